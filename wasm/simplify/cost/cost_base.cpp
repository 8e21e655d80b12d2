#include "simplify/cost/cost_base.h"

#include <algorithm>

namespace limber {

double CostBase::keepFactor(uint32_t edge) const {
  if (keep_.empty()) return 1;
  const auto [a, b] = mesh_.edge(edge);
  return 1 + SimplifyConstraints::kKeepFactor * std::max(keep_[a], keep_[b]);
}

void CostBase::collapse(const Collapse& step) {
  finder_.collapse(step);
  if (!keep_.empty()) keep_[step.kept] = std::max(keep_[step.kept], keep_[step.removed]);
}

}  // namespace limber
