#include "elastic/solvers/membrane_element.h"

#include <algorithm>
#include <cmath>

#include "elastic/shell_element.h"
#include "mesh/eigen_vec3.h"

namespace limber {

MembraneElement::MembraneElement(double shear, double second, const std::array<Vec3, 3>& rest) {
  std::array<Vec3, 3> edge;  // opposite to each corner
  for (int c = 0; c < 3; ++c) edge[c] = rest[(c + 2) % 3] - rest[(c + 1) % 3];
  const auto longest = std::ranges::max_element(edge, {}, squaredLength);
  const Vec3 doubleNormal = cross(edge[0], edge[1]);
  const double doubleArea = length(doubleNormal);
  const double flatness = squaredLength(*longest) > 0 ? doubleArea / squaredLength(*longest) : 0;
  if (flatness < kDegenerateTriangle) return;
  const Vec3 along = normalized(*longest), across = cross(doubleNormal / doubleArea, along);
  for (int c = 0; c < 3; ++c)  // edge c, rotated by 90 degrees, over twice the area
    gradients_.col(c) = Eigen::Vector2d(-dot(edge[c], across), dot(edge[c], along)) / doubleArea;
  const double area = 0.5 * doubleArea * std::min(1.0, flatness / kFlattestTriangle);
  dilation_ = std::sqrt((shear + second) * area);
  shear_ = std::sqrt(shear * area);
}

Eigen::Matrix<double, 3, 2> MembraneElement::deformationAt(const std::array<Vec3, 3>& positions) const {
  Eigen::Matrix<double, 3, 2> f = Eigen::Matrix<double, 3, 2>::Zero();
  // Relative to the first vertex, because positions far from the origin lose digits.
  for (int c = 1; c < 3; ++c) f += eigen(positions[c] - positions[0]) * gradients_.col(c).transpose();
  return f;
}

Eigen::Vector3d MembraneElement::strainOf(const Eigen::Matrix<double, 3, 2>& f) const {
  const double xx = 0.5 * (f.col(0).squaredNorm() - 1), yy = 0.5 * (f.col(1).squaredNorm() - 1),
               xy = 0.5 * f.col(0).dot(f.col(1));
  return {dilation_ * (xx + yy), shear_ * (xx - yy), 2 * shear_ * xy};
}

ConstraintStrain MembraneElement::strainAt(const std::array<Vec3, 3>& positions) const {
  ConstraintStrain result;
  if (shear_ == 0) return result;
  const Eigen::Matrix<double, 3, 2> f = deformationAt(positions);
  result.strain = strainOf(f);
  for (int c = 0; c < 3; ++c) {
    const Eigen::RowVector3d byXx = gradients_(0, c) * f.col(0).transpose(),
                             byYy = gradients_(1, c) * f.col(1).transpose(),
                             byXy = 0.5 *
                                    (gradients_(0, c) * f.col(1) + gradients_(1, c) * f.col(0)).transpose();
    result.jacobian.block<1, 3>(0, 3 * c) = dilation_ * (byXx + byYy);
    result.jacobian.block<1, 3>(1, 3 * c) = shear_ * (byXx - byYy);
    result.jacobian.block<1, 3>(2, 3 * c) = 2 * shear_ * byXy;
  }
  return result;
}

Eigen::Matrix4d MembraneElement::stressStiffnessAt(const std::array<Vec3, 3>& positions,
                                                   StressKind kind) const {
  const Eigen::Vector3d strain = strainOf(deformationAt(positions));
  // The second Piola-Kirchhoff stress times the area.
  const double mean = dilation_ * strain[0], half = shear_ * strain[1], across = shear_ * strain[2];
  const double radius = std::hypot(half, across), larger = mean + radius, smaller = mean - radius;
  Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();
  const bool isWhole = kind == StressKind::All || smaller >= 0;
  if (isWhole)
    stress << mean + half, across, across, mean - half;
  else if (larger > 0)
    stress << radius + half, across, across, radius - half;
  if (!isWhole && larger > 0) stress *= larger / (2 * radius);
  Eigen::Matrix4d result = Eigen::Matrix4d::Zero();
  result.topLeftCorner<3, 3>() = gradients_.transpose() * stress * gradients_;
  return result;
}

}  // namespace limber
