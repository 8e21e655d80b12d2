#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Whether a vertex is a corner of the outline, per vertex: a border vertex whose interior border angle, the
// sum of its triangles' angles, differs from 180 degrees by more than 30. `topology`: of `mesh`.
std::vector<uint8_t> findBorderCorners(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
