#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/feature_edges.h"

namespace limber {

// The corners around a vertex that lie between the same lines make a sector: all of them have one wedge, and
// in a collapse along a line the sector on each side of it joins the other end's sector on that side.
// [3 * t + c]: the sector of each corner, numbered from 0 in the order of their first corners. O(triangles).
std::vector<uint32_t> findSectors(const TriangleMesh& mesh, const Topology& topology,
                                  const FeatureEdges& features);

}  // namespace limber
