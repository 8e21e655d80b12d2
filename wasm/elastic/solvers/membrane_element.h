#pragma once

#include <Eigen/Core>
#include <array>

#include "base/vec3.h"
#include "elastic/solvers/constraint_strain.h"

namespace limber {

// A constant-strain triangle of a St. Venant-Kirchhoff sheet in plane stress. With the Green-Lagrange strain
// E = (F^T F - I) / 2 in the plane of the triangle at rest, its area A there, and the Lame constants times
// the thickness, its energy is
//   A (mu E : E + lambda / 2 tr(E)^2) = A / 2 ((mu + lambda) (Exx + Eyy)^2 + mu (Exx - Eyy)^2 + 4 mu Exy^2),
// and the components of its strain are the square roots of the three terms.
//
// The stiffness of a triangle grows with longest edge over height. If the height at rest is less than
// kFlattestTriangle times the longest edge, the energy is scaled down to that of a triangle of that flatness;
// a triangle of zero area at rest has no stiffness.
class MembraneElement {
 public:
  // `shear` mu h and `second` lambda h in N/m, mu > 0 and mu + lambda >= 0. Rest positions in metres.
  MembraneElement(double shear, double second, const std::array<Vec3, 3>& rest);

  ConstraintStrain strainAt(const std::array<Vec3, 3>& positions) const;
  // See SolverConstraints::stressStiffnessAt.
  Eigen::Matrix4d stressStiffnessAt(const std::array<Vec3, 3>& positions, StressKind kind) const;

 private:
  Eigen::Matrix<double, 3, 2> deformationAt(const std::array<Vec3, 3>& positions) const;  // F
  Eigen::Vector3d strainOf(const Eigen::Matrix<double, 3, 2>& deformation) const;

  // Columns: gradients of the barycentric coordinates in the plane at rest, so that F = sum_k x_k
  // gradient_k^T.
  Eigen::Matrix<double, 2, 3> gradients_ = Eigen::Matrix<double, 2, 3>::Zero();
  double dilation_ = 0, shear_ = 0;  // sqrt((mu + lambda) A) and sqrt(mu A)
};

}  // namespace limber
