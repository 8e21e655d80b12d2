#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/feature_edges.h"

namespace limber {

// A sector is the set of corners around a vertex between two successive feature edges. All of its corners
// have the same wedge, and in a collapse along a feature edge the sectors of both ends on one side of it
// become one. Returns [3 * t + c]: the sector of each corner, numbered from 0 in the order of their first
// corners. O(triangles).
std::vector<uint32_t> findSectors(const TriangleMesh& mesh, const Topology& topology,
                                  const FeatureEdges& features);

}  // namespace limber
