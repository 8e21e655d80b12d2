#include "mesh/manifold.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/disjoint_sets.h"
#include "base/parallel.h"

namespace limber {
namespace {

constexpr size_t kVerticesPerRange = 4096;
constexpr size_t kSmallFan = 16;

// The two edges that meet in a corner.
std::array<uint32_t, 2> edgesAt(const Topology& topology, Corner corner) {
  const uint32_t t = corner.triangle();
  return {topology.edgeOpposite(Corner(t, nextIndex(corner.index()))),
          topology.edgeOpposite(Corner(t, previousIndex(corner.index())))};
}

// The start and end of a walk around a vertex, and the number of triangles in between.
struct FanStart {
  uint32_t triangle, edge;
};
struct FanEnd {
  uint32_t edge;
  uint32_t passed;
};

// Walks around v from the start triangle, which is left across the edge that is not the start edge, to an
// edge without exactly two triangles, or back to the start edge.
FanEnd walkAround(const TriangleMesh& mesh, const Topology& topology, uint32_t v, const FanStart& start) {
  uint32_t t = start.triangle, in = start.edge;
  for (uint32_t passed = 1;; ++passed) {
    const auto pair = edgesAt(topology, cornerAt(mesh, t, v));
    const uint32_t out = pair[0] == in ? pair[1] : pair[0];
    const Topology::Edge& edge = topology.edges[out];
    if (out == start.edge || edge.useCount != 2) return {out, passed};
    const auto sharing = topology.trianglesAt(edge);
    t = sharing[sharing[0] == t ? 1 : 0];
    in = out;
  }
}

// Classifies the ends of edges with one triangle or with more than two; all other vertices stay Interior.
std::vector<VertexKind> classifyByEdges(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<VertexKind> kinds(mesh.vertexCount(), VertexKind::Interior);
  for (const Topology::Edge& edge : topology.edges) {
    if (edge.useCount == 2) continue;
    for (uint32_t v : {edge.a, edge.b})
      if (kinds[v] != VertexKind::NonManifoldEdge)
        kinds[v] = edge.useCount == 1 ? VertexKind::Border : VertexKind::NonManifoldEdge;
  }
  return kinds;
}

// The next two functions return whether the triangles of a vertex, which is not at the end of a non-manifold
// edge, are a single fan. In a walk each look-up depends on the previous one, which takes longer than
// fetching the few edges of a typical vertex at once and chaining them.
bool isOneFanByWalking(const TriangleMesh& mesh, const Topology& topology, uint32_t v, bool onBorder) {
  const auto around = topology.cornersAt(v);
  const auto walk = [&](uint32_t t, uint32_t entry) {
    return walkAround(mesh, topology, v, {t, entry}).passed == around.size();
  };
  if (!onBorder) return walk(around[0].triangle(), edgesAt(topology, around[0])[0]);
  // The walk through an open fan starts at one of its ends.
  for (const Corner corner : around)
    for (uint32_t e : edgesAt(topology, corner))
      if (topology.edges[e].useCount == 1) return walk(corner.triangle(), e);
  return false;
}

bool isOneFanByChaining(const Topology& topology, uint32_t v) {
  const auto around = topology.cornersAt(v);
  std::array<std::array<uint32_t, 2>, kSmallFan> pairs;
  for (size_t i = 0; i < around.size(); ++i) pairs[i] = edgesAt(topology, around[i]);
  size_t chained = 1;  // pairs[0 .. chained) are one chain
  for (int end : {1, 0}) {
    uint32_t open = pairs[0][end];
    for (size_t i = chained; i < around.size();) {
      const bool first = pairs[i][0] == open, second = pairs[i][1] == open;
      if (first || second) {
        open = pairs[i][first ? 1 : 0];
        std::swap(pairs[i], pairs[chained++]);
        i = chained;
      } else {
        ++i;
      }
    }
  }
  return chained == around.size();
}

bool isOneFan(const TriangleMesh& mesh, const Topology& topology, uint32_t v, bool onBorder) {
  return topology.cornersAt(v).size() <= kSmallFan ? isOneFanByChaining(topology, v)
                                                   : isOneFanByWalking(mesh, topology, v, onBorder);
}

}  // namespace

std::vector<VertexKind> classifyVertices(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<VertexKind> kinds = classifyByEdges(mesh, topology);
  parallelFor(kinds.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (auto v = static_cast<uint32_t>(begin); v < end; ++v) {
      if (kinds[v] == VertexKind::NonManifoldEdge) continue;
      if (topology.cornersAt(v).empty())
        kinds[v] = VertexKind::Unused;
      else if (!isOneFan(mesh, topology, v, kinds[v] == VertexKind::Border))
        kinds[v] = VertexKind::NonManifold;
    }
  });
  return kinds;
}

uint32_t countBoundaryLoops(const TriangleMesh& mesh, const Topology& topology) {
  DisjointSets sets(topology.edges.size());
  std::map<uint32_t, uint32_t> danglingAt;  // per vertex a border edge whose fan ends at a non-manifold edge
  const auto isBorder = [&](uint32_t e) { return topology.edges[e].useCount == 1; };

  for (uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (!isBorder(e)) continue;
    const Topology::Edge& edge = topology.edges[e];
    for (uint32_t v : {edge.a, edge.b}) {
      const FanEnd fan = walkAround(mesh, topology, v, {topology.trianglesAt(edge)[0], e});
      sets.unite(e, isBorder(fan.edge) ? fan.edge : danglingAt.try_emplace(v, e).first->second);
    }
  }
  uint32_t loops = 0;
  for (uint32_t e = 0; e < topology.edges.size(); ++e) loops += isBorder(e) && sets.rootOf(e) == e;
  return loops;
}

}  // namespace limber
