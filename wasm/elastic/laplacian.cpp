#include "elastic/laplacian.h"

#include <numeric>

#include "mesh/vertex_areas.h"

namespace limber {

SparsePencil laplacianPencil(const TriangleMesh& mesh, const Topology& topology) {
  SparsePencil pencil;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * topology.edges.size());
  for (const Topology::Edge& edge : topology.edges) {
    entries.emplace_back(edge.a, edge.a, 1);
    entries.emplace_back(edge.b, edge.b, 1);
    entries.emplace_back(edge.a, edge.b, -1);
    entries.emplace_back(edge.b, edge.a, -1);
  }
  const uint32_t n = mesh.vertexCount();
  pencil.k.resize(n, n);
  pencil.k.setFromTriplets(entries.begin(), entries.end());
  const auto areas = lumpedAreas(mesh);
  pencil.m = Eigen::Map<const Eigen::VectorXd>(areas.data(), n);
  pencil.firstUnknown.resize(n + 1);
  std::iota(pencil.firstUnknown.begin(), pencil.firstUnknown.end(), 0u);
  return pencil;
}

}  // namespace limber
