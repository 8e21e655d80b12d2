#pragma once

#include <cstdint>
#include <vector>

#include "fit/fit_part.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// Per triangle of the result 1 where it is one of the original's whose corners have not moved, else 0.
std::vector<uint8_t> findUnchangedTriangles(const TriangleMesh& original, const MeshAt& result);

// Locks the corners of unchanged triangles of part.result and fixes their edges, so that they stay as they
// are. `topology`: of part.result. `isUnchanged`: of the whole result.
void keepUnchanged(FitPart& part, const Topology& topology, const std::vector<uint8_t>& isUnchanged);

}  // namespace limber
