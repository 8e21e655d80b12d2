#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// The number of samples of each surface for a whole body.
inline constexpr uint32_t kGuardSamples = 20000;

// Finds the triangles of a moving mesh that are too far from its original, or that have points of the
// original too far from them. Distances are measured at samples of both surfaces: about `samples` points
// spread over the triangles, at least a few on each, and the vertices. The samples must respect nine tenths
// of the limit, which leaves a margin for the points between them. Triangles that are too far at the start
// must not move.
//
// If one point of the other surface is near enough to all of a triangle, it covers the triangle, whose
// samples then need no searches of their own. Meshes whose triangles are small compared to the limit
// therefore take one search per triangle.
class DeviationGuard {
 public:
  // Keeps references to `original` and to the tree over it. `limit`: a length in its units. `samples`: of
  // each surface.
  DeviationGuard(const TriangleMesh& original, const ClosestPointTree& tree, double limit,
                 uint32_t samples = kGuardSamples);

  // Sets the mesh from which vertices are about to move; it must have as many triangles as that of the
  // previous call. Returns 1 for each triangle that is already too far, else 0. O(n log n).
  std::vector<uint8_t> begin(const TriangleMesh& mesh);

  // `moved`: the mesh of `begin` with other positions. Returns 1 for each triangle that is too far and was
  // not at the start, else 0. `isChanged`: 0 for triangles that have not moved since they were last found
  // near enough, by `begin` or by a later call; empty: all triangles are tested. Fast if points move by less
  // than the remaining distance to the limit.
  std::vector<uint8_t> tooFar(const TriangleMesh& moved, const std::vector<uint8_t>& isChanged = {}) const;

 private:
  // A sample of the original, and a point of the mesh near it; triangle kNone if there was none at the start.
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
  double parts_;                                 // that each surface is cut into, approximately
  std::vector<std::array<double, 3>> middles_;   // samples of a triangle of the original ...
  std::vector<std::array<double, 3>> weights_;   // ... and of the mesh, as barycentric coordinates
  std::vector<SurfacePoint> coverOfOriginal_;    // per triangle of the original: on the mesh
  std::vector<OriginalSample> originalSamples_;  // of triangles that are not covered
  std::vector<SurfacePoint> coverOfMesh_;        // per triangle of the mesh: on the original
  std::vector<uint32_t> firstNear_;              // per triangle of the mesh: see `meshSamplesNear_`
  // Points of the original near samples of the mesh: those of triangle t that is not covered begin at
  // firstNear_[t]. Triangle kNone if none was near at the start.
  std::vector<SurfacePoint> meshSamplesNear_;
};

}  // namespace limber
