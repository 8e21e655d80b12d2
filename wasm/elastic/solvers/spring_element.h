#pragma once

#include <array>

#include "base/vec3.h"
#include "elastic/solvers/constraint_strain.h"

namespace limber {

// A spring of energy 1/2 k (|x_1 - x_0| - L)^2: its strain is sqrt(k) (|x_1 - x_0| - L).
class SpringElement {
 public:
  // `stiffness` k in N/m, >= 0; rest positions in metres, whose distance is L.
  SpringElement(double stiffness, const std::array<Vec3, 2>& rest);

  // If both ends coincide, the spring has no direction, and the derivatives are 0.
  ConstraintStrain strainAt(const std::array<Vec3, 2>& positions) const;
  // See SolverConstraints::stressStiffnessAt. Exact across the spring.
  Eigen::Matrix4d stressStiffnessAt(const std::array<Vec3, 2>& positions, StressKind kind) const;

 private:
  double root_, length_;
};

}  // namespace limber
