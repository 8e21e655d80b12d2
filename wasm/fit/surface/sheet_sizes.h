#pragma once

#include <Eigen/Core>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The area of a mesh and the length of its outline (all border edges), in units of the mesh. `topology`: of
// `mesh`. O(triangles).
Eigen::Vector2d measureSizes(const TriangleMesh& mesh, const Topology& topology);

// Their derivatives by the positions of the vertices: row 3 v + axis, a column for each. O(triangles).
Eigen::MatrixX2d sizeGradients(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
