#include "mesh/principal_axes.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "mesh/vertex_areas.h"

namespace limber {

namespace {

// Variances that differ by less than this fraction count as equal; lengths then differ by half of it.
constexpr double kAlike = 0.01;

}  // namespace

PrincipalAxes principalAxes(const TriangleMesh& mesh) {
  return principalAxes(mesh.positions, lumpedAreas(mesh));
}

PrincipalAxes principalAxes(std::span<const Vec3> points, std::span<const double> weights) {
  PrincipalAxes axes;
  double total = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    axes.centre += points[i] * weights[i];
    total += weights[i];
  }
  axes.centre *= 1 / total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points[i] - axes.centre;
    const Eigen::Vector3d offset(p.x, p.y, p.z);
    covariance += weights[i] * offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  for (int k = 0; k < 3; ++k) {
    axes.variance[static_cast<size_t>(k)] = solver.eigenvalues()[k];
    const Eigen::Vector3d axis = solver.eigenvectors().col(k);
    int largest = 0;
    for (int c = 1; c < 3; ++c)
      if (std::abs(axis[c]) > std::abs(axis[largest]) + 1e-9) largest = c;
    const double sign = axis[largest] < 0 ? -1 : 1;
    axes.axis[static_cast<size_t>(k)] = {sign * axis[0], sign * axis[1], sign * axis[2]};
  }
  return axes;
}

Vec3 longestAxis(const TriangleMesh& mesh) {
  const PrincipalAxes axes = principalAxes(mesh);
  const int longest = bounds(mesh).longestAxis();
  Vec3 nearest;
  for (size_t k = 0; k < 3; ++k)
    if (axes.variance[k] >= (1 - kAlike) * axes.variance[2]) nearest += axes.axis[k] * axes.axis[k][longest];
  const double part = length(nearest);
  return part > 0 ? nearest * (1 / part) : axes.axis[2];
}

}  // namespace limber
