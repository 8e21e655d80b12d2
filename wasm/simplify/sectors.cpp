#include "simplify/sectors.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace limber {
namespace {

uint32_t rootOf(std::vector<uint32_t>& parent, uint32_t corner) {
  while (parent[corner] != corner) corner = parent[corner] = parent[parent[corner]];
  return corner;
}

}  // namespace

std::vector<uint32_t> findSectors(const TriangleMesh& mesh, const Topology& topology, const Lines& lines) {
  std::vector<uint32_t> parent(3 * size_t{mesh.triangleCount()});
  std::iota(parent.begin(), parent.end(), 0);
  const auto cornerAt = [&](uint32_t t, uint32_t v) {
    const Triangle& triangle = mesh.triangles[t];
    return 3 * t + (triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2);
  };
  for (size_t e = 0; e < topology.edges.size(); ++e) {
    const Topology::Edge& edge = topology.edges[e];
    if (edge.useCount != 2 || lines.isLine[e]) continue;
    const auto triangles = topology.trianglesAt(edge);
    for (const uint32_t v : {edge.a, edge.b}) {
      const auto [first, second] =
          std::minmax({rootOf(parent, cornerAt(triangles[0], v)), rootOf(parent, cornerAt(triangles[1], v))});
      parent[second] = first;
    }
  }
  std::vector<uint32_t> sectors(parent.size());
  uint32_t count = 0;
  for (uint32_t corner = 0; corner < parent.size(); ++corner) {
    const uint32_t root = rootOf(parent, corner);  // the lowest corner of the sector
    sectors[corner] = root == corner ? count++ : sectors[root];
  }
  return sectors;
}

}  // namespace limber
