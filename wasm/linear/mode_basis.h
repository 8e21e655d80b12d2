#pragma once

#include <Eigen/Core>

namespace limber {

// Eigenpairs of any symmetric pencil (K, M), K phi = lambda M phi: column k of phi belongs to lambda[k].
// Eigenvalues ascend. Columns are orthogonal in M and mass-normalised, phi^T M phi = I, and zero modes are
// omitted, unless the owner documents otherwise.
struct ModeBasis {
  Eigen::VectorXd lambda;  // omega^2 of a vibration
  Eigen::MatrixXd phi;     // phi(unknown, k): unknowns x modes

  Eigen::Index modeCount() const { return lambda.size(); }
};

}  // namespace limber
