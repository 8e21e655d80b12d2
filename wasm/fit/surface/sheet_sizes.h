#pragma once

#include <Eigen/Core>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The area of a mesh and the length of its outline (all border edges), in units of the mesh. `topology`: of
// `mesh`. O(triangles).
Eigen::Vector2d measureSizes(const TriangleMesh& mesh, const Topology& topology);

// Their derivatives with respect to the positions of the vertices: rows 3 v + axis, one column for each.
// O(triangles).
Eigen::MatrixX2d sizeGradients(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
