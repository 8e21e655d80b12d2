#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// What the surface is like at a vertex; the first that applies.
enum class VertexKind : uint8_t {
  Unused,           // no triangle
  NonManifoldEdge,  // at the end of an edge with more than two triangles
  NonManifold,      // its triangles are more than one fan (joined across edges at the vertex)
  Border,           // one open fan
  Interior,         // one closed fan
};

// Per vertex. O(triangles).
std::vector<VertexKind> classifyVertices(const TriangleMesh& mesh, const Topology& topology);

// The number of closed walks along edges with one triangle. Where walks touch at a vertex each follows its
// own fan, so that two holes that share a corner are two; walks whose fans end at edges with more than two
// triangles are joined there, for such a border has no own end.
uint32_t countBoundaryLoops(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
