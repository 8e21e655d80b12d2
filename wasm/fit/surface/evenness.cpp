#include "fit/surface/evenness.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fit/tuning.h"
#include "mesh/corner.h"
#include "mesh/eigen_vec3.h"
#include "mesh/vertex_areas.h"

namespace limber {

namespace {

void addSegments(const TriangleMesh& mesh, const FeatureSegments& features, Neighbourhoods& around,
                 std::vector<double>& weight) {
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

void addTriangles(const TriangleMesh& mesh, NormalWeight normalWeight, Neighbourhoods& around,
                  std::vector<double>& weight) {
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const double area = triangleArea(mesh, t);
    const Eigen::Vector3d normal = eigen(normalized(areaNormal(mesh, t)));
    const Vec3 centre = triangleCentre(mesh, t);
    for (int c = 0; c < 3; ++c) {
      const uint32_t v = mesh.triangles[t][static_cast<size_t>(c)];
      if (around.isOnFeature[v]) continue;
      const double share = normalWeight == NormalWeight::Area ? area : angleAt(mesh, Corner(t, c));
      around.normals[v] += share * normal * normal.transpose();
      around.middle[v] += area * centre;
      weight[v] += area;
    }
  }
}

}  // namespace

Neighbourhoods neighbourhoodsOf(const TriangleMesh& mesh, const FeatureSegments& features,
                                NormalWeight normalWeight) {
  const uint32_t n = mesh.vertexCount();
  Neighbourhoods around{vertexAreas(mesh), std::vector<Eigen::Matrix3d>(n, Eigen::Matrix3d::Zero()),
                        std::vector<Vec3>(n), std::vector<uint8_t>(n, 0)};
  std::vector<double> weight(n, 0);
  addSegments(mesh, features, around, weight);
  addTriangles(mesh, normalWeight, around, weight);
  for (uint32_t v = 0; v < n; ++v)
    around.middle[v] = weight[v] > 0 ? around.middle[v] / weight[v] : mesh.positions[v];
  return around;
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
