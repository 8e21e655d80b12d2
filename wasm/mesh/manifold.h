#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// How the triangles around a vertex are connected. The first kind that applies is used.
enum class VertexKind : uint8_t {
  Unused,           // no triangle
  NonManifoldEdge,  // at the end of an edge with more than two triangles
  NonManifold,      // more than one fan, a fan being triangles joined across edges at the vertex
  Border,           // one open fan
  Interior,         // one closed fan
};

// The kind of each vertex. O(triangles).
std::vector<VertexKind> classifyVertices(const TriangleMesh& mesh, const Topology& topology);

// The number of boundary loops: closed walks along edges with one triangle. If loops touch at a vertex, each
// follows its own fan, so that two holes that share a vertex count as two. Borders whose fans end at edges
// with more than two triangles are joined there, because they have no other continuation.
uint32_t countBoundaryLoops(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
