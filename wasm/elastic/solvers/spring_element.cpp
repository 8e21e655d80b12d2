#include "elastic/solvers/spring_element.h"

#include <cmath>

namespace limber {

SpringElement::SpringElement(double stiffness, const std::array<Vec3, 2>& rest)
    : root_(std::sqrt(stiffness)), length_(length(rest[1] - rest[0])) {}

ConstraintStrain SpringElement::strainAt(const std::array<Vec3, 2>& positions) const {
  const Vec3 along = positions[1] - positions[0], direction = normalized(along);
  ConstraintStrain result;
  result.strain[0] = root_ * (length(along) - length_);
  for (int axis = 0; axis < 3; ++axis) {
    result.jacobian(0, axis) = -root_ * direction[axis];
    result.jacobian(0, 3 + axis) = root_ * direction[axis];
  }
  return result;
}

Eigen::Matrix4d SpringElement::stressStiffnessAt(const std::array<Vec3, 2>& positions,
                                                 StressKind kind) const {
  Eigen::Matrix4d result = Eigen::Matrix4d::Zero();
  const double current = length(positions[1] - positions[0]);
  if (current == 0 || (kind == StressKind::Tension && current <= length_)) return result;
  const double tension = root_ * root_ * (current - length_) / current;  // per length
  result.topLeftCorner<2, 2>() << tension, -tension, -tension, tension;
  return result;
}

}  // namespace limber
