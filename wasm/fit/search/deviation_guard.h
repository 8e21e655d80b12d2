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
class DeviationGuard {
 public:
  // Keeps a reference to `original`. `limit`: a length in its units. `samples`: of each surface.
  DeviationGuard(const TriangleMesh& original, double limit, uint32_t samples = kGuardSamples);

  // Takes the mesh that vertices are about to move from. Returns 1 for each triangle that is too far already,
  // else 0. O(n log n).
  std::vector<uint8_t> begin(const TriangleMesh& mesh);

  // `moved`: the mesh of `begin` with other positions. Returns 1 for each triangle that is too far and was
  // not at the start, else 0. Fast where points move by less than what is left of the limit.
  std::vector<uint8_t> tooFar(const TriangleMesh& moved) const;

 private:
  // A point of the original that a sample of the moving mesh is near; triangle kNone where none is at the
  // start.
  struct NearOriginalPoint {
    Vec3 position;
    uint32_t triangle = kNone;
  };
  Vec3 meshPoint(const TriangleMesh& mesh, size_t i) const;
  double nearEnough() const;
  void checkOriginal(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const;
  void checkMoved(const TriangleMesh& moved, std::vector<uint8_t>& isFar) const;

  double allowed_;                              // largest distance of a sample
  double parts_;                                // that each surface is cut into, about
  std::vector<std::array<double, 3>> weights_;  // barycentric coordinates of the samples of every triangle
  ClosestPointTree tree_;                       // of the original
  std::vector<Vec3> originalPoints_;            // samples of the original
  std::vector<SurfacePoint>
      meshPointsNear_;  // per sample of the original a point of the mesh near it, as below
  std::vector<NearOriginalPoint> originalPointsNear_;  // per sample of the mesh, triangle by triangle
};

}  // namespace limber
