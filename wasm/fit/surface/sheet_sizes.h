#pragma once

#include <Eigen/Core>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The area of a mesh and the length of its outline (all border edges), and their derivatives by the positions
// of its vertices. In units of the mesh.
struct SheetSizes {
  Eigen::Vector2d values;      // area, length
  Eigen::MatrixX2d gradients;  // row 3 v + axis, a column for each value
};
// `topology`: of `mesh`. O(triangles).
SheetSizes measureSizes(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
