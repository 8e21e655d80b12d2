#pragma once

#include <Eigen/Core>

namespace limber {

// Eigenpairs of a symmetric pencil (K, M), K phi = lambda M phi, whatever K and M stand for: column k of phi
// belongs to lambda[k]. Eigenvalues ascend. Columns are orthogonal in M and mass-normalised, phi^T M phi = I,
// unless the holder says otherwise. Zero modes are left out unless the holder says otherwise.
struct ModeBasis {
  Eigen::VectorXd lambda;  // omega^2 of a vibration
  Eigen::MatrixXd phi;     // phi(unknown, k): unknowns x modes

  Eigen::Index modeCount() const { return lambda.size(); }
};

}  // namespace limber
