#pragma once

#include <Eigen/Core>
#include <vector>

namespace limber {

// By how much the modes of a mesh miss those of its original: the residuals that the fit minimises. For modes
// psi of the mesh that have been aligned with those of the original (see alignModes) they are the entries
// (i, j) of
//   psi^T K psi / sqrt(lambda_i lambda_j) - identity,
// with eigenvalues lambda of the original: the diagonal holds the relative errors of eigenvalues, and what is
// off it tells how modes of neighbouring frequencies mix. Each is multiplied by the root of its weight.
struct Mismatch {
  Eigen::VectorXd residual;  // r
  // J^T: 3 vertexCount rows 3 v + axis and a column for each residual, its derivative by the coordinates (Fox
  // and Kapoor 1968).
  Eigen::MatrixXd jacobian;
  double squares = 0, weight = 0;  // weighted sum of the squared errors of eigenvalues, and of their weights

  double meanSquare() const { return weight > 0 ? squares / weight : 0; }
};

// The residuals of all `parts` in one list.
Mismatch join(const std::vector<Mismatch>& parts);

}  // namespace limber
