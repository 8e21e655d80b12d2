#pragma once

#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

#include "mesh/corner.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Incidences between vertices, edges and triangles. Edges are undirected and sorted by (smaller vertex,
// larger vertex); all lists are ascending.
struct Topology {
  struct Edge {
    uint32_t a, b;                // a < b
    uint32_t firstUse, useCount;  // its triangles: edgeTriangles[firstUse .. firstUse + useCount)
  };
  std::vector<Edge> edges;
  std::vector<uint32_t> edgeTriangles;
  std::vector<uint32_t> edgeOfCorner;  // [3 * t + c]: the edge opposite to corner c of triangle t
  std::vector<uint8_t> clashes;  // per edge: 1 if it has two triangles that traverse it in the same direction
  std::vector<uint32_t> vertexStart;  // size vertexCount + 1
  std::vector<Corner> vertexCorners;  // corners at v: vertexCorners[vertexStart[v] .. vertexStart[v + 1])
  // Per vertex its component: vertices joined by edges. Components are numbered by their lowest vertex.
  std::vector<uint32_t> componentOfVertex;
  uint32_t componentCount = 0;

  // The edge opposite to a corner.
  uint32_t edgeOpposite(Corner corner) const { return edgeOfCorner[corner.flatIndex()]; }
  std::span<const Corner> cornersAt(uint32_t v) const {
    return {vertexCorners.data() + vertexStart[v], vertexStart[v + 1] - vertexStart[v]};
  }
  auto trianglesAround(uint32_t v) const {
    return cornersAt(v) | std::views::transform([](Corner corner) { return corner.triangle(); });
  }
  std::span<const uint32_t> trianglesAt(const Edge& e) const {
    return {edgeTriangles.data() + e.firstUse, e.useCount};
  }
};

// O(n log n). Every vertex of `mesh` should belong to a triangle; one that does not is a component of its
// own.
Topology buildTopology(const TriangleMesh& mesh);
// The same without components: componentOfVertex stays empty.
Topology buildIncidence(const TriangleMesh& mesh);

// The edge between two vertices; null if there is none. O(log n).
const Topology::Edge* edgeBetween(const Topology& topology, uint32_t a, uint32_t b);

// The component of each triangle, which is that of its first vertex.
std::vector<uint32_t> componentOfTriangle(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
