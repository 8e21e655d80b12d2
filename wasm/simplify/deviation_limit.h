#pragma once

#include <cstdint>
#include <vector>

#include "query/nearest.h"
#include "simplify/collapse_mesh.h"

namespace limber {

// Keeps the surface within a distance of the input, measured at samples in both directions. Every vertex of
// the input and, on each of its triangles, points on the edges and the centres of 1 to 64 equal parts (fewer
// on finer meshes) must stay within the distance of the triangles that have replaced theirs. On every
// triangle that a collapse changes, the moved corner and points inside and on the edges must lie within the
// distance of the input. A margin of 15 % is left for the surface between the samples; large triangles over
// rugged borders may exceed it.
class DeviationLimit {
 public:
  // Keeps a reference to both. `limit` is a length in the mesh's units.
  DeviationLimit(const TriangleMesh& input, const CollapseMesh& mesh, double limit);

  // Whether a collapse stays within the limit. O(samples on the triangles around it, times these triangles).
  bool allows(const Collapse& step);
  // Prepares `collapse` for a step that is carried out regardless of its distance; a sample that is near none
  // of its triangles is assigned to the first of them.
  void follow(const Collapse& step);
  // Assigns the samples to their new triangles. Must be called right after `allows` has returned true for the
  // same step, or after `follow`.
  void collapse();

 private:
  struct Changed {
    uint32_t triangle;
    Vec3 q, r;  // its corners that do not move
  };

  void addSamples(uint32_t t, int cuts);
  void startReassigning(const Collapse& step);
  void collectChanged(const Collapse& step);
  bool reassignSample(uint32_t sample, const Vec3& target);
  bool isNearInput(const Vec3& p, uint32_t guess) const;
  bool isNearInput(const Changed& changed, const Vec3& target) const;
  void attach(uint32_t sample, uint32_t triangle);

  const CollapseMesh& mesh_;
  double squaredLimit_;
  NearestTriangle nearest_;
  std::vector<Vec3> samples_;      // the vertices, then points on the triangles; in the frame of CollapseMesh
  std::vector<uint32_t> inputOf_;  // per sample: a triangle of the input that contains it
  std::vector<uint32_t> first_;    // per triangle: its first sample
  std::vector<uint32_t> next_;     // per sample: the next one on the same triangle
  std::vector<Changed> changed_;   // of the last `allows`
  std::vector<uint32_t> emptied_;  // triangles whose samples are reassigned
  std::vector<uint32_t> moving_, to_;  // samples, and the triangles that they are assigned to
};

}  // namespace limber
