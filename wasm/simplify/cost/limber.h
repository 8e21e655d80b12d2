#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "simplify/cost/cost_base.h"

namespace limber {

// Method `limber`: (3 E_QEM + s (1 + w sigma) L^2) (1 + g (1 / q - 1) (1 + p)), with L the length of the
// edge, sigma the larger strain rank at its ends, q the worst quality (Eq. 9) among the changed triangles
// after the collapse, and s, w, g the weights of size, strain and quality. The sliver price p is (0.15 /
// q)^4, at most 3, where q is below 0.3 and the triangles around both ends are all better than 0.24, else 0:
// it prevents slivers where there are none yet. All terms are squared lengths or pure numbers, so units do
// not matter.
class LimberCost : public CostBase {
 public:
  static constexpr std::string_view kName = "limber";
  // Costs within 8 % of each other count as equal, which halves the time of a simplification.
  static constexpr double kTolerance = 1.08;

  LimberCost(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
             const SimplifyOptions& options);

  static constexpr bool boundsAreCosts() { return false; }
  static constexpr bool followsNeighbourhood() { return false; }
  // The bound is the size cost alone.
  void setBounds(std::span<const uint32_t> edges);
  // The bound becomes the cost without the price of quality.
  void raiseBounds(std::span<const uint32_t> edges);
  // Lower than before if the edge is shorter now, but no lower than its size cost.
  double expectedCost(uint32_t edge, double cost);
  double cost(uint32_t edge) const { return bound(edge) * qualityFactor(edge, target(edge)); }
  CostTerms terms(uint32_t edge, const Optimum& optimum) const;
  void collapse(const Collapse& step);

 private:
  void averageStrain(std::span<const float> strain);
  double sizeCost(uint32_t edge) const;
  double strainAt(uint32_t edge) const;
  double qualityFactor(uint32_t edge, const Vec3& target) const;
  double worstQualityAfter(uint32_t edge, const Vec3& target) const;
  double worstQualityBefore(uint32_t edge) const;
  double sliverPrice(uint32_t edge, double quality) const;

  double strainWeight_, qualityWeight_, sizeWeight_;
  std::vector<float> strainOfVertex_;  // mean strain rank over the area merged into a vertex; or empty
  std::vector<float> sizeCosts_;       // per edge: the size cost that belongs to its last cost
};

}  // namespace limber
