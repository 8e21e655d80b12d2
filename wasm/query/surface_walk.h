#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// Finds the point of a surface closest to a given point without leaving the sheet that the search starts on:
// from the given triangles it walks across edges as long as that leads closer. Sheets that are close in space
// but far apart on the surface are therefore never confused. Each thread needs a walk of its own; mesh and
// topology must outlive it.
class SurfaceWalk {
 public:
  SurfaceWalk(const TriangleMesh& mesh, const Topology& topology);

  // Whether the walk may cross `edge` to triangle `to`.
  using MayCross = std::function<bool(uint32_t edge, uint32_t to)>;

  // A local minimum of the distance to `point`, searched from all triangles of `start`, which must not be
  // empty. Ties go to the lower triangle. O(triangles visited).
  ClosestPoint closest(const Vec3& point, std::span<const uint32_t> start, const MayCross& mayCross);

 private:
  void visit(uint32_t triangle, const Vec3& point);

  const TriangleMesh& mesh_;
  const Topology& topology_;
  double tolerance_;                 // distances that differ by less count as equal
  std::vector<uint32_t> visitedAt_;  // per triangle: the last walk that visited it
  uint32_t walk_ = 0;
  std::vector<ClosestPoint> visited_;
  ClosestPoint best_;
};

}  // namespace limber
