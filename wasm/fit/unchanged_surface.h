#pragma once

#include <cstdint>
#include <vector>

#include "fit/fit_part.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// Per triangle of the result: 1 if it is a triangle of the original whose corners have not moved, else 0.
std::vector<uint8_t> findUnchangedTriangles(const TriangleMesh& original, const MeshAt& result);

// Locks the corners of unchanged triangles of part.result and fixes their edges, so that they do not change.
// `topology`: of part.result. `isUnchanged`: of the whole result.
void keepUnchanged(FitPart& part, const Topology& topology, const std::vector<uint8_t>& isUnchanged);

}  // namespace limber
