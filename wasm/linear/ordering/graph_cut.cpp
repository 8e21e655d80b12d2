#include "linear/ordering/graph_cut.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kImbalance = 0.5;       // the largest increase for unequal halves
constexpr double kSmallestHalf = 0.4;    // of the weight of both halves: smaller ones are penalised
constexpr double kSmallHalfPenalty = 2;  // per unit of missing weight

}  // namespace

double cutCost(int64_t left, int64_t right, int64_t between) {
  const auto smaller = static_cast<double>(std::min(left, right)), both = static_cast<double>(left + right);
  if (smaller == 0) return HUGE_VAL;
  const double missing = std::max(0.0, kSmallestHalf * both - smaller);
  return static_cast<double>(between) * (1 + kImbalance * (1 - 2 * smaller / both)) +
         kSmallHalfPenalty * missing;
}

double separatorCost(const NodeGraph& graph, const Sides& sides) {
  int64_t weight[3] = {};
  for (uint32_t i = 0; i < graph.nodeCount(); ++i) weight[sides[i]] += graph.weight[i];
  return cutCost(weight[Left], weight[Right], weight[Between]);
}

}  // namespace limber
