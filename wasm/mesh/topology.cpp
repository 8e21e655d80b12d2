#include "mesh/topology.h"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.h"
#include "base/parallel.h"

namespace limber {
namespace {

constexpr size_t kVerticesPerRange = 8192;
constexpr size_t kTrianglesPerRange = 65536;  // at least, because every range takes memory for every vertex
constexpr size_t kMaxRanges = 4;

// Counting sort of the corners by their vertices, range by range of the triangles.
void collectCorners(const TriangleMesh& mesh, Topology& topology) {
  const uint32_t n = mesh.vertexCount();
  const size_t grain = std::max(kTrianglesPerRange, mesh.triangles.size() / kMaxRanges + 1);
  std::vector<std::vector<uint32_t>> next((mesh.triangles.size() + grain - 1) / grain);
  parallelFor(mesh.triangles.size(), grain, [&](size_t begin, size_t end) {
    std::vector<uint32_t>& count = next[begin / grain];
    count.assign(n, 0);
    for (size_t t = begin; t < end; ++t)
      for (const uint32_t v : mesh.triangles[t]) ++count[v];
  });
  topology.vertexStart.resize(n + 1);
  uint32_t sum = 0;
  for (uint32_t v = 0; v < n; ++v) {
    topology.vertexStart[v] = sum;
    for (std::vector<uint32_t>& range : next) sum += std::exchange(range[v], sum);
  }
  topology.vertexStart[n] = sum;
  topology.vertexCorners.resize(sum);
  parallelFor(mesh.triangles.size(), grain, [&](size_t begin, size_t end) {
    for (auto t = static_cast<uint32_t>(begin); t < end; ++t)
      for (uint32_t c = 0; c < 3; ++c)
        topology.vertexCorners[next[begin / grain][mesh.triangles[t][c]]++] = Corner(t, c);
  });
}

// How a triangle uses an edge of a vertex, as one number whose order is that of its parts: the other vertex
// of the edge, the corner opposite to the edge, and whether the triangle traverses the edge from the other
// vertex.
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

// Writes the uses of the edges whose smaller vertex is v to `uses` and returns their end.
EdgeUse* collectUses(const TriangleMesh& mesh, const Topology& topology, uint32_t v, EdgeUse* uses) {
  for (const Corner corner : topology.cornersAt(v)) {
    const uint32_t t = corner.triangle();
    const int next = nextIndex(corner.index()), previous = previousIndex(corner.index());
    const uint32_t after = mesh.triangles[t][next], before = mesh.triangles[t][previous];
    // Branch-free, because branches would be unpredictable. A triangle without area may have an edge from v
    // to v.
    *uses = edgeUse(after, Corner(t, previous), false);
    uses += after >= v;
    *uses = edgeUse(before, Corner(t, next), true);
    uses += before > v;
  }
  return uses;
}

// Most vertices have few uses, for which insertion is much faster than a general sort.
void sortUses(EdgeUse* begin, EdgeUse* end) {
  if (end - begin > 32) return std::sort(begin, end);
  for (EdgeUse* next = begin; next != end; ++next) {
    const EdgeUse use = *next;
    EdgeUse* slot = next;
    for (; slot != begin && use < slot[-1]; --slot) *slot = slot[-1];
    *slot = use;
  }
}

// The edges whose smaller vertices are in one range, with their uses stored consecutively.
struct EdgeRange {
  std::vector<Topology::Edge> edges;  // `firstUse` counts within the range
  std::vector<uint8_t> clashes;
  std::vector<Corner> uses;  // the corners opposite to the edges
};

void addEdge(uint32_t v, std::span<const EdgeUse> uses, EdgeRange& range) {
  const auto firstUse = static_cast<uint32_t>(range.uses.size());
  range.edges.push_back({v, otherVertex(uses[0]), firstUse, static_cast<uint32_t>(uses.size())});
  range.clashes.push_back(uses.size() == 2 && ((uses[0] ^ uses[1]) & 1) == 0);
  for (const EdgeUse use : uses) range.uses.push_back(oppositeCorner(use));
}

EdgeRange edgesOf(const TriangleMesh& mesh, const Topology& topology, uint32_t begin, uint32_t end) {
  EdgeRange range;
  const size_t corners = topology.vertexStart[end] - topology.vertexStart[begin];
  range.uses.reserve(corners);
  range.edges.reserve(corners / 2);
  range.clashes.reserve(corners / 2);
  std::vector<EdgeUse> uses;
  for (uint32_t v = begin; v < end; ++v) {
    uses.resize(std::max(uses.size(), 2 * topology.cornersAt(v).size() + 1));
    EdgeUse* const last = collectUses(mesh, topology, v, uses.data());
    sortUses(uses.data(), last);
    for (EdgeUse *first = uses.data(), *next; first != last; first = next) {
      next = first + 1;
      while (next != last && otherVertex(*next) == otherVertex(*first)) ++next;
      addEdge(v, {first, next}, range);
    }
  }
  return range;
}

// Copies a range to its position in the whole: its first edge is number `edge`, its first use number `use`.
void copyEdges(const EdgeRange& range, uint32_t edge, uint32_t use, Topology& topology) {
  std::ranges::copy(range.clashes, topology.clashes.begin() + edge);
  for (const Topology::Edge& own : range.edges) {
    topology.edges[edge] = {own.a, own.b, use + own.firstUse, own.useCount};
    for (uint32_t i = own.firstUse; i < own.firstUse + own.useCount; ++i) {
      topology.edgeTriangles[use + i] = range.uses[i].triangle();
      topology.edgeOfCorner[range.uses[i].flatIndex()] = edge;
    }
    ++edge;
  }
}

void collectEdges(const TriangleMesh& mesh, Topology& topology) {
  std::vector<EdgeRange> ranges((mesh.vertexCount() + kVerticesPerRange - 1) / kVerticesPerRange);
  parallelFor(mesh.vertexCount(), kVerticesPerRange, [&](size_t begin, size_t end) {
    ranges[begin / kVerticesPerRange] =
        edgesOf(mesh, topology, static_cast<uint32_t>(begin), static_cast<uint32_t>(end));
  });
  std::vector<uint32_t> firstEdge{0}, firstUse{0};
  for (const EdgeRange& range : ranges) {
    firstEdge.push_back(firstEdge.back() + static_cast<uint32_t>(range.edges.size()));
    firstUse.push_back(firstUse.back() + static_cast<uint32_t>(range.uses.size()));
  }
  topology.edges.resize(firstEdge.back());
  topology.clashes.resize(firstEdge.back());
  topology.edgeTriangles.resize(3 * size_t{mesh.triangleCount()});
  topology.edgeOfCorner.resize(3 * size_t{mesh.triangleCount()});
  parallelFor(ranges.size(), 1, [&](size_t i, size_t) {
    copyEdges(ranges[i], firstEdge[i], firstUse[i], topology);
    ranges[i] = {};
  });
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
