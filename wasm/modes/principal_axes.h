#pragma once

#include <array>

#include "mesh/triangle_mesh.h"

namespace limber {

// The principal axes of a surface through its centre of area, unit, from the thinnest extent to the longest;
// each points to the positive side of its largest component.
struct PrincipalAxes {
  Vec3 centre;
  std::array<Vec3, 3> axis;
};
PrincipalAxes principalAxes(const TriangleMesh& mesh);

}  // namespace limber
