#include "fit/surface/evenness.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "fit/tuning.h"
#include "mesh/corner.h"
#include "mesh/eigen_vec3.h"

namespace limber {

namespace {

constexpr size_t kPerRange = 2048;

// Neighbourhoods during summation: middles have yet to be divided by their weights.
struct NeighbourhoodSums {
  Neighbourhoods around;
  std::vector<double> weight;
};

void addSegments(const TriangleMesh& mesh, const FeatureSegments& features, NeighbourhoodSums& sums) {
  auto& [around, weight] = sums;
  for (const Triangle& segment : features.segments.triangles)
    for (int end = 0; end < 2; ++end) {
      const uint32_t v = segment[static_cast<size_t>(end)];
      const Vec3 edge = mesh.positions[segment[1]] - mesh.positions[segment[0]];
      const Eigen::Vector3d along = eigen(normalized(edge));
      around.isOnFeature[v] = 1;
      around.normals[v] += length(edge) * (Eigen::Matrix3d::Identity() - along * along.transpose());
      around.middle[v] +=
          0.5 * mesh.positions[segment[static_cast<size_t>(1 - end)]] + 0.5 * mesh.positions[v];
      weight[v] += 1;
    }
}

double angleAt(const TriangleMesh& mesh, Corner corner) {
  const uint32_t t = corner.triangle();
  const Vec3& apex = mesh.corner(t, corner.index());
  const Vec3 p = mesh.corner(t, nextIndex(corner.index())) - apex;
  const Vec3 q = mesh.corner(t, previousIndex(corner.index())) - apex;
  return std::atan2(length(cross(p, q)), dot(p, q));
}

// Sums over the triangles around a vertex, in their order for any number of threads.
void addTriangles(const TriangleMesh& mesh, const Topology& topology, NormalWeight normalWeight,
                  NeighbourhoodSums& sums) {
  auto& around = sums.around;
  auto& weight = sums.weight;
  std::vector<Vec3> normals(mesh.triangleCount());
  parallelFor(normals.size(), kPerRange, [&](size_t begin, size_t end) {
    for (auto t = static_cast<uint32_t>(begin); t < end; ++t) normals[t] = areaNormal(mesh, t);
  });
  parallelFor(mesh.vertexCount(), kPerRange, [&](size_t begin, size_t end) {
    for (auto v = static_cast<uint32_t>(begin); v < end; ++v)
      for (const Corner corner : topology.cornersAt(v)) {
        const uint32_t t = corner.triangle();
        const double area = length(normals[t]) / 2;
        around.area[v] += area / 3;
        if (around.isOnFeature[v]) continue;
        const Eigen::Vector3d normal = eigen(normalized(normals[t]));
        const double share = normalWeight == NormalWeight::Area ? area : angleAt(mesh, corner);
        around.normals[v] += share * normal * normal.transpose();
        around.middle[v] += area * triangleCentre(mesh, t);
        weight[v] += area;
      }
  });
}

}  // namespace

Neighbourhoods neighbourhoodsOf(const TriangleMesh& mesh, const Topology& topology,
                                const FeatureSegments& features, NormalWeight normalWeight) {
  const uint32_t n = mesh.vertexCount();
  NeighbourhoodSums sums{{std::vector<double>(n, 0), std::vector<Eigen::Matrix3d>(n, Eigen::Matrix3d::Zero()),
                          std::vector<Vec3>(n), std::vector<uint8_t>(n, 0)},
                         std::vector<double>(n, 0)};
  addSegments(mesh, features, sums);
  addTriangles(mesh, topology, normalWeight, sums);
  auto& [around, weight] = sums;
  parallelFor(n, kPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v)
      around.middle[v] = weight[v] > 0 ? around.middle[v] / weight[v] : mesh.positions[v];
  });
  return std::move(around);
}

Eigen::Matrix3d tangentialFreedom(const Eigen::Matrix3d& normals) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(normals);
  const double limit = tuning::surface::kCreaseRatio * solver.eigenvalues()[2];
  Eigen::Matrix3d freedom = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 2 && limit > 0; ++k) {
    const double share = std::max(0.0, 1 - std::max(0.0, solver.eigenvalues()[k]) / limit);
    freedom += share * solver.eigenvectors().col(k) * solver.eigenvectors().col(k).transpose();
  }
  return freedom;
}

}  // namespace limber
