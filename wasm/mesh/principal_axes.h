#pragma once

#include <array>
#include <span>

#include "mesh/triangle_mesh.h"

namespace limber {

// The principal axes through the centre: unit vectors, from the direction of least variance to that of most;
// the largest component of each is positive.
struct PrincipalAxes {
  Vec3 centre;
  std::array<Vec3, 3> axis;
};
// Those of a surface, weighted by area.
PrincipalAxes principalAxes(const TriangleMesh& mesh);
// Those of points; weights[i] >= 0 belongs to points[i].
PrincipalAxes principalAxes(std::span<const Vec3> points, std::span<const double> weights);

}  // namespace limber
