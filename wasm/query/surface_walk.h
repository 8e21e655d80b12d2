#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// Finds the point of a surface closest to a given one without leaving the sheet it starts on: from some
// triangles it goes on across their edges for as long as that leads nearer. Two sheets that lie close in
// space but are far apart on the surface are never mixed up. One walk per thread; mesh and topology must
// outlive it.
class SurfaceWalk {
 public:
  SurfaceWalk(const TriangleMesh& mesh, const Topology& topology);

  // Whether the walk may go from triangle `from` across edge `edge` to triangle `to`.
  using MayCross = std::function<bool(uint32_t edge, uint32_t to)>;

  // A local minimum of the distance to `point`, started at all triangles of `start` (not empty). Ties go to
  // the lower triangle index. O(triangles looked at).
  ClosestPoint closest(const Vec3& point, std::span<const uint32_t> start, const MayCross& mayCross);

 private:
  void visit(uint32_t triangle, const Vec3& point);

  const TriangleMesh& mesh_;
  const Topology& topology_;
  double tolerance_;                 // distances that differ by less are one
  std::vector<uint32_t> visitedAt_;  // per triangle: the walk that has last looked at it
  uint32_t walk_ = 0;
  std::vector<ClosestPoint> visited_;
  ClosestPoint best_;
};

}  // namespace limber
