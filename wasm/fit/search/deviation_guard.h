#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// Samples of each surface that are enough for a whole body.
inline constexpr uint32_t kGuardSamples = 20000;

// Tells which triangles of a moving mesh are too far from its original, or have points of the original too
// far from them. Both surfaces are judged at samples: about `samples` points spread over the triangles, at
// least a few on each, and the vertices. The samples must respect nine tenths of the limit, which leaves a
// margin for the points between them. Triangles that are too far from the start must not move.
//
// A point of the other surface that is near enough to all of a triangle covers it: then its samples need no
// points of their own. So meshes whose triangles are small beside the limit take one search a triangle.
class DeviationGuard {
 public:
  // Keeps references to `original` and to the tree over it. `limit`: a length in its units. `samples`: of
  // each surface.
  DeviationGuard(const TriangleMesh& original, const ClosestPointTree& tree, double limit,
                 uint32_t samples = kGuardSamples);

  // Takes the mesh that vertices are about to move from; it has as many triangles as that of the call before.
  // Returns 1 for each triangle that is too far already, else 0. O(n log n).
  std::vector<uint8_t> begin(const TriangleMesh& mesh);

  // `moved`: the mesh of `begin` with other positions. Returns 1 for each triangle that is too far and was
  // not at the start, else 0. `isChanged`: 0 for triangles that are where they were when they were last
  // found near enough, by `begin` or by a call after it; empty: all are asked about. Fast where points move
  // by less than what is left of the limit.
  std::vector<uint8_t> tooFar(const TriangleMesh& moved, const std::vector<uint8_t>& isChanged = {}) const;

 private:
  // A sample of the original, and a point of the mesh near it; triangle kNone where none is at the start.
  struct OriginalSample {
    Vec3 position;
    SurfacePoint near = {};
  };
  using Marks = std::vector<uint8_t>;  // per triangle of the mesh

  void coverOriginal(const TriangleMesh& mesh, Marks& isFar);
  void coverMesh(const TriangleMesh& mesh, Marks& isFar);
  std::vector<OriginalSample> uncoveredSamples() const;
  std::vector<OriginalSample> unclearSamples(const TriangleMesh& moved, const Marks& isChanged) const;
  void checkOriginal(const TriangleMesh& moved, const Marks& isChanged, Marks& isFar) const;
  void checkMoved(const TriangleMesh& moved, const Marks& isChanged, Marks& isFar) const;
  bool isTooFar(const TriangleMesh& moved, uint32_t t) const;
  double nearEnough() const;

  const TriangleMesh& original_;
  const ClosestPointTree& tree_;                 // of the original
  double allowed_;                               // largest distance of a sample
  double parts_;                                 // that each surface is cut into, about
  std::vector<std::array<double, 3>> middles_;   // samples of a triangle of the original ...
  std::vector<std::array<double, 3>> weights_;   // ... and of the mesh, as barycentric coordinates
  std::vector<SurfacePoint> coverOfOriginal_;    // per triangle of the original: on the mesh
  std::vector<OriginalSample> originalSamples_;  // of what is not covered
  std::vector<SurfacePoint> coverOfMesh_;        // per triangle of the mesh: on the original
  std::vector<uint32_t> firstNear_;              // per triangle of the mesh: see `meshSamplesNear_`
  // Points of the original near samples of the mesh: those of triangle t that is not covered begin at
  // firstNear_[t]. Triangle kNone where none is near at the start.
  std::vector<SurfacePoint> meshSamplesNear_;
};

}  // namespace limber
