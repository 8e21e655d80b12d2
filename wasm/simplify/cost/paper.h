#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "query/nearest.h"
#include "simplify/cost/cost_base.h"

namespace limber {

// Method `paper`: E_QEM + alpha E_strain + beta E_curv + gamma E_tri_q (Eq. 11), in the frame of
// OptimumFinder. E_strain is the larger strain rank of the input triangles nearest to both ends, E_curv the
// curvature of the input vertex nearest to the optimum, E_tri_q the mean quality deficit 1 - q of the changed
// triangles (Eq. 10). The paper does not say how the triangles of one collapse are combined into one number.
// alpha, beta and gamma are strainWeight, curvatureWeight and qualityWeight: the larger they are, the more
// surface accuracy they may cost.
class PaperCost : public CostBase {
 public:
  static constexpr std::string_view kName = "paper";
  static constexpr double kTolerance = 1;

  // Keeps references to `input` and the lists of `guidance`.
  PaperCost(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
            const SimplifyOptions& options);

  bool boundsAreCosts() const { return qualityWeight_ == 0; }
  bool followsNeighbourhood() const { return qualityWeight_ > 0; }
  void setBounds(std::span<const uint32_t> edges);
  void raiseBounds(std::span<const uint32_t> edges) { setBounds(edges); }
  double expectedCost(uint32_t, double cost) { return cost; }
  double cost(uint32_t edge) const;
  CostTerms terms(uint32_t edge, const Optimum& optimum) const;
  void collapse(const Collapse& step);

 private:
  void startGuidance(const TriangleMesh& input);
  double costAt(uint32_t edge, const Optimum& optimum) const;
  double guidanceCost(uint32_t edge, const Vec3& target) const;
  double strainAt(uint32_t edge) const;
  double meanQualityDeficit(uint32_t edge, const Vec3& target) const;
  uint32_t nearestInputVertex(const Vec3& target, uint32_t edge) const;
  Vec3 inFile(const Vec3& p) const;

  Guidance guidance_;
  double strainWeight_, curvatureWeight_, qualityWeight_;
  NearestTriangle nearestTriangle_;
  NearestVertex nearestVertex_;
  std::vector<uint32_t> nearestInputTriangle_;  // per vertex; empty without strain
  std::vector<uint32_t> nearestInputVertex_;    // per vertex; empty without curvature
  std::vector<float> guidanceCosts_;            // per edge: guidanceCost at its last `setBounds`
};

}  // namespace limber
