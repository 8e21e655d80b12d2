#include "simplify/sectors.h"

#include "base/disjoint_sets.h"

namespace limber {

std::vector<uint32_t> findSectors(const TriangleMesh& mesh, const Topology& topology,
                                  const FeatureEdges& features) {
  DisjointSets sets(3 * size_t{mesh.triangleCount()});
  for (size_t e = 0; e < topology.edges.size(); ++e) {
    const Topology::Edge& edge = topology.edges[e];
    if (edge.useCount != 2 || features.isFeature(e)) continue;
    const auto triangles = topology.trianglesAt(edge);
    for (const uint32_t v : {edge.a, edge.b})
      sets.unite(cornerAt(mesh, triangles[0], v).flatIndex(), cornerAt(mesh, triangles[1], v).flatIndex());
  }
  std::vector<uint32_t> sectors(3 * size_t{mesh.triangleCount()});
  uint32_t count = 0;
  for (uint32_t corner = 0; corner < sectors.size(); ++corner) {
    const uint32_t root = sets.rootOf(corner);  // the lowest corner of the sector
    sectors[corner] = root == corner ? count++ : sectors[root];
  }
  return sectors;
}

}  // namespace limber
