#pragma once

#include <Eigen/Core>

namespace limber {

// The stress that contributes to the stiffness of a constraint: tension makes it stiffer across its
// direction, compression softer, until it buckles.
enum class StressKind { Tension, All };

// The generalised strain of a constraint, scaled so that its energy is 1/2 |strain|^2 in joules, and its
// derivatives with respect to the positions of its vertices in metres (column 3 k + axis for its k-th
// vertex). Rows and columns beyond those of the constraint are 0.
struct ConstraintStrain {
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 12> jacobian = Eigen::Matrix<double, 3, 12>::Zero();
};

}  // namespace limber
