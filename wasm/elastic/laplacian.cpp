#include "elastic/laplacian.h"

#include <numeric>

#include "mesh/vertex_areas.h"

namespace limber {

StiffnessModel laplacianModel(const TriangleMesh& mesh, const Topology& topology) {
  StiffnessModel model;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * topology.edges.size());
  for (const Topology::Edge& edge : topology.edges) {
    entries.emplace_back(edge.a, edge.a, 1);
    entries.emplace_back(edge.b, edge.b, 1);
    entries.emplace_back(edge.a, edge.b, -1);
    entries.emplace_back(edge.b, edge.a, -1);
  }
  const uint32_t n = mesh.vertexCount();
  model.stiffness.resize(n, n);
  model.stiffness.setFromTriplets(entries.begin(), entries.end());
  const auto areas = lumpedAreas(mesh);
  model.mass = Eigen::Map<const Eigen::VectorXd>(areas.data(), n);
  model.firstUnknown.resize(n + 1);
  std::iota(model.firstUnknown.begin(), model.firstUnknown.end(), 0u);
  return model;
}

}  // namespace limber
