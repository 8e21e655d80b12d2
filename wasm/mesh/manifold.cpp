#include "mesh/manifold.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "base/parallel.h"

namespace limber {
namespace {

constexpr size_t kVerticesPerRange = 4096;

// The two edges of triangle t that meet in vertex v.
std::array<uint32_t, 2> edgesAt(const TriangleMesh& mesh, const Topology& topology, uint32_t t, uint32_t v) {
  const Triangle& triangle = mesh.triangles[t];
  const uint32_t c = triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
  return {topology.edgeOfCorner[3 * t + (c + 1) % 3], topology.edgeOfCorner[3 * t + (c + 2) % 3]};
}

// Where a walk around a vertex ended, and how many triangles it has passed.
struct FanEnd {
  uint32_t edge;
  uint32_t passed;
};

// Turns around v, starting in triangle t and leaving it across the edge that is not `entry`, until an edge
// without exactly two triangles, or back at `entry`.
FanEnd turnAround(const TriangleMesh& mesh, const Topology& topology, uint32_t v, uint32_t t,
                  uint32_t entry) {
  uint32_t in = entry;
  for (uint32_t passed = 1;; ++passed) {
    const auto pair = edgesAt(mesh, topology, t, v);
    const uint32_t out = pair[0] == in ? pair[1] : pair[0];
    const Topology::Edge& edge = topology.edges[out];
    if (out == entry || edge.useCount != 2) return {out, passed};
    const auto sharing = topology.trianglesAt(edge);
    t = sharing[sharing[0] == t ? 1 : 0];
    in = out;
  }
}

VertexKind classify(const TriangleMesh& mesh, const Topology& topology, uint32_t v) {
  const auto around = topology.trianglesAround(v);
  if (around.empty()) return VertexKind::Unused;
  uint32_t start = around[0], entry = edgesAt(mesh, topology, start, v)[0];
  bool border = false;
  for (uint32_t t : around)
    for (uint32_t e : edgesAt(mesh, topology, t, v)) {
      if (topology.edges[e].useCount > 2) return VertexKind::NonManifoldEdge;
      if (topology.edges[e].useCount == 1 && !border) {
        border = true;
        start = t;
        entry = e;
      }
    }
  const FanEnd fan = turnAround(mesh, topology, v, start, entry);
  if (fan.passed < around.size()) return VertexKind::NonManifold;
  return border ? VertexKind::Border : VertexKind::Interior;
}

uint32_t rootOf(std::vector<uint32_t>& parent, uint32_t e) {
  while (parent[e] != e) e = parent[e] = parent[parent[e]];
  return e;
}

}  // namespace

std::vector<VertexKind> classifyVertices(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<VertexKind> kinds(mesh.vertexCount());
  parallelFor(kinds.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) kinds[v] = classify(mesh, topology, static_cast<uint32_t>(v));
  });
  return kinds;
}

uint32_t countBoundaryLoops(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> parent(topology.edges.size());
  std::iota(parent.begin(), parent.end(), 0);
  std::map<uint32_t, uint32_t> danglingAt;  // per vertex a border edge whose fan ends at a non-manifold edge
  const auto join = [&](uint32_t e, uint32_t f) { parent[rootOf(parent, e)] = rootOf(parent, f); };
  const auto isBorder = [&](uint32_t e) { return topology.edges[e].useCount == 1; };

  for (uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (!isBorder(e)) continue;
    const Topology::Edge& edge = topology.edges[e];
    for (uint32_t v : {edge.a, edge.b}) {
      const FanEnd fan = turnAround(mesh, topology, v, topology.trianglesAt(edge)[0], e);
      join(e, isBorder(fan.edge) ? fan.edge : danglingAt.try_emplace(v, e).first->second);
    }
  }
  uint32_t loops = 0;
  for (uint32_t e = 0; e < topology.edges.size(); ++e) loops += isBorder(e) && rootOf(parent, e) == e;
  return loops;
}

}  // namespace limber
