#pragma once

#include <array>
#include <span>

#include "mesh/triangle_mesh.h"

namespace limber {

// Principal axes through the centre, unit, from the thinnest extent to the longest; each points to the
// positive side of its largest component.
struct PrincipalAxes {
  Vec3 centre;
  std::array<Vec3, 3> axis;
};
// Of a surface.
PrincipalAxes principalAxes(const TriangleMesh& mesh);
// Of points with a weight each.
PrincipalAxes principalAxes(std::span<const Vec3> points, std::span<const double> weights);

}  // namespace limber
