#include "simplify/cost/qem.h"

namespace limber {

QemCost::QemCost(const TriangleMesh&, const CollapseMesh& mesh, const Guidance&,
                 const SimplifyOptions& options)
    : CostBase(mesh, options, options.sizeWeight) {}

void QemCost::setBounds(std::span<const uint32_t> edges) {
  finder_.forEach(edges, [&](uint32_t edge, const Optimum& optimum) {
    setCandidate(edge, optimum, optimum.error * keepFactor(edge));
  });
}

CostTerms QemCost::terms(uint32_t edge, const Optimum& optimum) const {
  CostTerms terms;
  terms.keep = keepFactor(edge);
  terms.size = finder_.sizeError(edge);
  terms.error = optimum.error - terms.size;
  return terms;
}

}  // namespace limber
