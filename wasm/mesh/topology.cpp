#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"

namespace limber {
namespace {

void collectCorners(const TriangleMesh& mesh, Topology& topology) {
  auto& start = topology.vertexStart;
  start.assign(mesh.vertexCount() + 1, 0);
  for (const Triangle& triangle : mesh.triangles)
    for (uint32_t v : triangle) ++start[v + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  topology.vertexCorners.resize(start.back());
  std::vector<uint32_t> next(start.begin(), start.end() - 1);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (uint32_t c = 0; c < 3; ++c) topology.vertexCorners[next[mesh.triangles[t][c]]++] = Corner(t, c);
}

// A triangle's use of an edge, in an order by the other vertex and then by the corner: the other vertex, the
// corner opposite to the edge, and whether the triangle runs the edge from there.
using EdgeUse = uint64_t;
EdgeUse edgeUse(uint32_t other, Corner opposite, bool fromOther) {
  return EdgeUse{other} << 33 | EdgeUse{opposite.code()} << 1 | fromOther;
}
uint32_t otherVertex(EdgeUse use) {
  return static_cast<uint32_t>(use >> 33);
}
Corner oppositeCorner(EdgeUse use) {
  return Corner::fromCode(static_cast<uint32_t>(use >> 1));
}

// Writes the uses of the edges whose smaller vertex is v and returns their end.
EdgeUse* collectUses(const TriangleMesh& mesh, const Topology& topology, uint32_t v, EdgeUse* uses) {
  for (const Corner corner : topology.cornersAt(v)) {
    const uint32_t t = corner.triangle();
    const int next = nextIndex(corner.index()), previous = previousIndex(corner.index());
    const uint32_t after = mesh.triangles[t][next], before = mesh.triangles[t][previous];
    // Without branches, which nobody could predict. A triangle without area may have an edge from v to v.
    *uses = edgeUse(after, Corner(t, previous), false);
    uses += after >= v;
    *uses = edgeUse(before, Corner(t, next), true);
    uses += before > v;
  }
  return uses;
}

// Most vertices have few uses, for which plain insertion is much faster than a general sort.
void sortUses(EdgeUse* begin, EdgeUse* end) {
  if (end - begin > 32) return std::sort(begin, end);
  for (EdgeUse* next = begin; next != end; ++next) {
    const EdgeUse use = *next;
    EdgeUse* slot = next;
    for (; slot != begin && use < slot[-1]; --slot) *slot = slot[-1];
    *slot = use;
  }
}

void addEdge(uint32_t v, std::span<const EdgeUse> uses, uint32_t firstUse, Topology& topology) {
  const auto edge = static_cast<uint32_t>(topology.edges.size());
  topology.edges.push_back({v, otherVertex(uses[0]), firstUse, static_cast<uint32_t>(uses.size())});
  topology.clashes.push_back(uses.size() == 2 && ((uses[0] ^ uses[1]) & 1) == 0);
  for (const EdgeUse use : uses) {
    const Corner corner = oppositeCorner(use);
    topology.edgeTriangles[firstUse++] = corner.triangle();
    topology.edgeOfCorner[corner.flatIndex()] = edge;
  }
}

void collectEdges(const TriangleMesh& mesh, Topology& topology) {
  const size_t expected = size_t{mesh.vertexCount()} + mesh.triangleCount();  // of a disc
  topology.edges.reserve(expected);
  topology.clashes.reserve(expected);
  topology.edgeTriangles.resize(3 * size_t{mesh.triangleCount()});
  topology.edgeOfCorner.resize(3 * size_t{mesh.triangleCount()});
  uint32_t useCount = 0;
  std::vector<EdgeUse> uses;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    uses.resize(std::max(uses.size(), 2 * topology.cornersAt(v).size() + 1));
    EdgeUse* const end = collectUses(mesh, topology, v, uses.data());
    sortUses(uses.data(), end);
    for (EdgeUse *first = uses.data(), *next; first != end; first = next) {
      next = first + 1;
      while (next != end && otherVertex(*next) == otherVertex(*first)) ++next;
      addEdge(v, {first, next}, useCount, topology);
      useCount += static_cast<uint32_t>(next - first);
    }
  }
}

void numberComponents(const TriangleMesh& mesh, Topology& topology) {
  DisjointSets sets(mesh.vertexCount());
  for (const Topology::Edge& edge : topology.edges) sets.unite(edge.a, edge.b);
  topology.componentOfVertex.resize(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const uint32_t root = sets.rootOf(v);
    topology.componentOfVertex[v] = root == v ? topology.componentCount++ : topology.componentOfVertex[root];
  }
}

}  // namespace

Topology buildIncidence(const TriangleMesh& mesh) {
  Topology topology;
  collectCorners(mesh, topology);
  collectEdges(mesh, topology);
  return topology;
}

Topology buildTopology(const TriangleMesh& mesh) {
  Topology topology = buildIncidence(mesh);
  numberComponents(mesh, topology);
  return topology;
}

const Topology::Edge* edgeBetween(const Topology& topology, uint32_t a, uint32_t b) {
  const std::pair<uint32_t, uint32_t> ends = std::minmax(a, b);
  const auto found = std::ranges::lower_bound(
      topology.edges, ends, {}, [](const Topology::Edge& edge) { return std::pair(edge.a, edge.b); });
  const bool isThere = found != topology.edges.end() && std::pair(found->a, found->b) == ends;
  return isThere ? &*found : nullptr;
}

std::vector<uint32_t> componentOfTriangle(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> component(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    component[t] = topology.componentOfVertex[mesh.triangles[t][0]];
  return component;
}

}  // namespace limber
