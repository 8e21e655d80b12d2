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
  std::array<double, 3> variance;  // along each, times the sum of the weights
};
// The principal axes of a surface, weighted by area.
PrincipalAxes principalAxes(const TriangleMesh& mesh);
// The principal axes of points; weights[i] >= 0 belongs to points[i].
PrincipalAxes principalAxes(std::span<const Vec3> points, std::span<const double> weights);

// The direction of largest variance of a surface. If other principal axes have nearly the same variance, as
// in a square, and with them all directions that they span, it is the one of these directions that is nearest
// to the longest side of the box (the first of equal ones).
Vec3 longestAxis(const TriangleMesh& mesh);

}  // namespace limber
