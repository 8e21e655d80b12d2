#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// Per connected component (topology.componentOfVertex) the component that bounds the same solid from outside:
// itself for an outer shell, the enclosing shell for a cavity, kNone for a component that bounds no solid,
// because it is not closed, has an edge with more than two triangles or with clashing windings, or has no
// volume.
//
// A cavity lies directly within an outer shell (no third closed component lies between) and is wound the
// other way. Only relative winding matters, so a body that is inside out as a whole is a solid too. A
// component that floats in a cavity is an outer shell again. Components must not intersect each other,
// because only one vertex and the bounding box of each decide which of them contains it. O(n log n) unless
// very many components lie above each other.
std::vector<uint32_t> solidHosts(const TriangleMesh& mesh, const Topology& topology);

// How many components have a host in this list: those that bound a solid from outside or as a cavity. O(n).
uint32_t countSolidComponents(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
