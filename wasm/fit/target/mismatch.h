#pragma once

#include <Eigen/Core>
#include <vector>

namespace limber {

// The mismatch between the modes of a mesh and those of its original: the residuals that the fit minimises.
// For modes psi of the mesh that have been aligned with those of the original (see alignModes) they are the
// entries (i, j) of
//   psi^T K psi / sqrt(lambda_i lambda_j) - identity,
// with eigenvalues lambda of the original: the diagonal entries are the relative errors of eigenvalues, and
// the off-diagonal entries measure the mixing of modes of neighbouring frequencies. Each is multiplied by the
// root of its weight.
struct Mismatch {
  Eigen::VectorXd residual;  // r
  // J^T: rows 3 v + axis and a column for each residual, its derivative with respect to the coordinates (Fox
  // and Kapoor 1968).
  Eigen::MatrixXd jacobian;
  double squares = 0, weight = 0;  // sums of weighted squared errors of eigenvalues, and of weights

  double meanSquare() const { return weight > 0 ? squares / weight : 0; }
};

// Concatenates the residuals of all `parts`.
Mismatch join(const std::vector<Mismatch>& parts);

}  // namespace limber
