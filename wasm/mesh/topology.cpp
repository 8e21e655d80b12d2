#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace limber {
namespace {

// One triangle's use of an edge, kept with the other uses of the edge's smaller vertex.
struct EdgeUse {
  uint32_t largerVertex;
  uint32_t corner;  // 3 * t + c, opposite to the edge

  bool operator<(const EdgeUse& other) const {
    return largerVertex != other.largerVertex ? largerVertex < other.largerVertex : corner < other.corner;
  }
};

std::pair<uint32_t, uint32_t> edgeOpposite(const Triangle& triangle, int c) {
  return std::minmax(triangle[(c + 1) % 3], triangle[(c + 2) % 3]);
}

// Turns the number of items of bucket v in counts[v + 1] into where bucket v starts, in counts[v].
void accumulate(std::vector<uint32_t>& counts) {
  std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

void collectVertexTriangles(const TriangleMesh& mesh, Topology& topology) {
  auto& start = topology.vertexStart;
  start.assign(mesh.vertexCount() + 1, 0);
  for (const Triangle& triangle : mesh.triangles)
    for (uint32_t v : triangle) ++start[v + 1];
  accumulate(start);
  topology.vertexTriangles.resize(start.back());
  std::vector<uint32_t> next(start.begin(), start.end() - 1);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (uint32_t v : mesh.triangles[t]) topology.vertexTriangles[next[v]++] = t;
}

// The uses of all edges, bucketed by the smaller vertex: start[a] .. start[a + 1].
std::vector<EdgeUse> collectEdgeUses(const TriangleMesh& mesh, std::vector<uint32_t>& start) {
  start.assign(mesh.vertexCount() + 1, 0);
  for (const Triangle& triangle : mesh.triangles)
    for (int c = 0; c < 3; ++c) ++start[edgeOpposite(triangle, c).first + 1];
  accumulate(start);
  std::vector<EdgeUse> uses(start.back());
  std::vector<uint32_t> next(start.begin(), start.end() - 1);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) {
      const auto [a, b] = edgeOpposite(mesh.triangles[t], c);
      uses[next[a]++] = {b, 3 * t + c};
    }
  return uses;
}

// Most vertices have few uses, for which plain insertion is much faster than a general sort.
void sortUses(EdgeUse* begin, EdgeUse* end) {
  if (end - begin > 32) return std::sort(begin, end);
  for (EdgeUse* next = begin; next != end; ++next) {
    const EdgeUse use = *next;
    EdgeUse* place = next;
    for (; place != begin && use < place[-1]; --place) *place = place[-1];
    *place = use;
  }
}

void collectEdges(const TriangleMesh& mesh, Topology& topology) {
  std::vector<uint32_t> start;
  std::vector<EdgeUse> uses = collectEdgeUses(mesh, start);
  topology.edges.reserve(uses.size() / 2);
  topology.edgeTriangles.reserve(uses.size());
  topology.edgeOfCorner.resize(uses.size());
  for (uint32_t a = 0; a < mesh.vertexCount(); ++a) {
    sortUses(uses.data() + start[a], uses.data() + start[a + 1]);
    for (uint32_t i = start[a]; i < start[a + 1]; ++i) {
      if (i == start[a] || uses[i].largerVertex != uses[i - 1].largerVertex)
        topology.edges.push_back({a, uses[i].largerVertex, i, 0});
      ++topology.edges.back().useCount;
      topology.edgeTriangles.push_back(uses[i].corner / 3);
      topology.edgeOfCorner[uses[i].corner] = static_cast<uint32_t>(topology.edges.size() - 1);
    }
  }
}

// Union by the smaller index, so that a set's root is its smallest vertex; paths are halved on the way.
uint32_t rootOf(std::vector<uint32_t>& parent, uint32_t v) {
  while (parent[v] != v) v = parent[v] = parent[parent[v]];
  return v;
}

void numberComponents(const TriangleMesh& mesh, Topology& topology) {
  std::vector<uint32_t> parent(mesh.vertexCount());
  std::iota(parent.begin(), parent.end(), 0);
  for (const Topology::Edge& edge : topology.edges) {
    const uint32_t a = rootOf(parent, edge.a), b = rootOf(parent, edge.b);
    parent[std::max(a, b)] = std::min(a, b);
  }
  topology.componentOfVertex.resize(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const uint32_t root = rootOf(parent, v);
    topology.componentOfVertex[v] = root == v ? topology.componentCount++ : topology.componentOfVertex[root];
  }
}

}  // namespace

Topology buildTopology(const TriangleMesh& mesh) {
  Topology topology;
  collectVertexTriangles(mesh, topology);
  collectEdges(mesh, topology);
  numberComponents(mesh, topology);
  return topology;
}

std::vector<uint32_t> componentOfTriangle(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> component(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    component[t] = topology.componentOfVertex[mesh.triangles[t][0]];
  return component;
}

}  // namespace limber
