#pragma once

#include <cstdint>
#include <vector>

#include "query/nearest.h"
#include "simplify/collapse_mesh.h"

namespace limber {

// Keeps the surface within a distance of the input, judged at samples in both directions: every vertex and,
// on each triangle of the input, points on its edges and the middles of one to 64 equal parts (fewer on finer
// meshes) must stay that near to the triangles that have taken their place; and on every triangle that a
// collapse changes, the moved corner and points inside and on its edges must lie that near to the input. A
// margin of 15 % is for what lies between; on large triangles over rugged borders it may take more.
class DeviationLimit {
 public:
  // Keeps a reference to both. `limit` is a length in the mesh's units.
  DeviationLimit(const TriangleMesh& input, const CollapseMesh& mesh, double limit);

  // Whether a collapse that is legal otherwise stays within the limit. Its time grows with the samples there.
  bool allows(const Collapse& step);
  // Hands the samples over; to be called right after `allows` has said yes to the same step.
  void collapse();

 private:
  struct Changed {
    uint32_t triangle;
    Vec3 q, r;  // its corners that stay
  };

  void addSamples(uint32_t t, int cuts);
  void collectChanged(const Collapse& step);
  bool reassignSample(uint32_t sample, const Vec3& target);
  bool isNearInput(const Vec3& p, uint32_t guess) const;
  bool isNearInput(const Changed& changed, const Vec3& target) const;
  void attach(uint32_t sample, uint32_t triangle);

  const CollapseMesh& mesh_;
  double squaredLimit_;
  NearestTriangle nearest_;
  std::vector<Vec3> samples_;      // the vertices, then points on the triangles, as CollapseMesh holds them
  std::vector<uint32_t> inputOf_;  // per sample: a triangle of the input that has it
  std::vector<uint32_t> first_;    // per triangle: its first sample
  std::vector<uint32_t> next_;     // per sample: the next one on the same triangle
  std::vector<Changed> changed_;   // of the last `allows`
  std::vector<uint32_t> emptied_;  // triangles whose samples go elsewhere
  std::vector<uint32_t> moving_, to_;  // samples, and the triangles that they go to
};

}  // namespace limber
