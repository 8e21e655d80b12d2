#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simplify/cost/optimum.h"
#include "simplify/simplify_options.h"

namespace limber {

// The terms of a cost: cost = (error + size + strain + curvature + quality) * keep, in squared lengths in a
// frame with a diagonal of 300, except for the dimensionless terms of `paper`.
struct CostTerms {
  double error = 0;      // E_QEM with its weight, attributes included
  double size = 0;       // of the squared length of the edge
  double strain = 0;     // limber: the addition of strain to the size
  double curvature = 0;  // paper
  // paper: E_tri_q with its weight; limber: the addition of the worst triangle to all of the above
  double quality = 0;
  double keep = 1;  // factor of the keep weights

  double total() const { return (error + size + strain + curvature + quality) * keep; }
};

// The base of the cost policies: the optimum of each edge, keep weights, and per edge a lower bound of its
// cost. See CostPolicy for the role of the members in the collapse loop.
class CostBase {
 public:
  Optimum optimum(uint32_t edge) const { return finder_.find(edge); }
  float bound(uint32_t edge) const { return candidates_[edge].bound; }
  Vec3 target(uint32_t edge) const {
    const auto [x, y, z] = candidates_[edge].target;
    return mesh_.fromFile({x, y, z});
  }

 protected:
  // Keeps a reference to `mesh`.
  CostBase(const CollapseMesh& mesh, const SimplifyOptions& options, double lengthWeight = 0)
      : mesh_(mesh),
        finder_(mesh, options.constraints, lengthWeight),
        keep_(options.constraints.keep.begin(), options.constraints.keep.end()),
        candidates_(mesh.edgeCount()) {}

  // 1 + 99 times the larger keep weight of the two ends.
  double keepFactor(uint32_t edge) const;
  void setBound(uint32_t edge, double bound) { candidates_[edge].bound = static_cast<float>(bound); }
  void setCandidate(uint32_t edge, const Optimum& optimum, double bound) {
    candidates_[edge] = {mesh_.inFile(optimum.position), static_cast<float>(bound)};
  }
  // Must be called before the mesh carries out a collapse.
  void collapse(const Collapse& step);

  const CollapseMesh& mesh_;
  OptimumFinder finder_;

 private:
  struct Candidate {
    std::array<float, 3> target;  // in the file
    float bound;
  };
  std::vector<float> keep_;            // [v]: the largest keep weight of the vertices merged into v; or empty
  std::vector<Candidate> candidates_;  // per edge
};

}  // namespace limber
