#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// For each connected component (topology.componentOfVertex) the one that bounds the same solid from outside:
// itself for an outer shell, the enclosing component for a cavity of that, kNone where it bounds nothing: not
// closed, an edge with more than two triangles, neighbours wound against each other, or no volume.
//
// A cavity lies within an outer shell, directly (no third closed component lies between), and is wound the
// other way. Only relative winding counts, so a body that is inside out as a whole is a solid too. What
// floats in a cavity is an outer shell again. Components are taken not to cross each other: where one lies is
// told by one of its vertices and its bounding box. O(n log n) unless very many components lie above each
// other.
std::vector<uint32_t> solidHosts(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
