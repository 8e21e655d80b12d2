#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "simplify/cost/cost_base.h"

namespace limber {

// Method `qem`: E_QEM alone (see OptimumFinder), with the size weight times the squared length of the edge as
// part of the error. Larger size weights collapse short edges first, so triangles become more uniform in size
// and the surface is approximated less closely.
class QemCost : public CostBase {
 public:
  static constexpr std::string_view kName = "qem";
  static constexpr double kTolerance = 1;

  QemCost(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
          const SimplifyOptions& options);

  static constexpr bool boundsAreCosts() { return true; }
  static constexpr bool followsNeighbourhood() { return false; }
  void setBounds(std::span<const uint32_t> edges);
  void raiseBounds(std::span<const uint32_t> edges) { setBounds(edges); }
  double expectedCost(uint32_t, double cost) { return cost; }
  double cost(uint32_t edge) const { return bound(edge); }
  CostTerms terms(uint32_t edge, const Optimum& optimum) const;
  void collapse(const Collapse& step) { CostBase::collapse(step); }
};

}  // namespace limber
