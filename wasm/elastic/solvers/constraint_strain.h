#pragma once

#include <Eigen/Core>

namespace limber {

// Which stress a constraint's stiffness takes account of: tension makes it stiffer across, and compression
// softer, down to buckling.
enum class StressKind { Tension, All };

// The generalised strain of a constraint, scaled so that its energy is 1/2 |strain|^2 in joules, and its
// derivatives by the positions of its vertices in metres (column 3 k + axis for its k-th vertex). Rows and
// columns beyond those of the constraint are 0.
struct ConstraintStrain {
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 12> jacobian = Eigen::Matrix<double, 3, 12>::Zero();
};

}  // namespace limber
