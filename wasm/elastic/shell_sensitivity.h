#pragma once

#include <Eigen/Core>
#include <span>

#include "base/job.h"
#include "elastic/shell.h"

namespace limber {

// An entry (i, j) of a reduced matrix psi_i^T (K - lambda M) psi_j.
struct ModePair {
  int i = 0, j = 0;  // columns of psi
  double lambda = 0;
};

// Derivatives of psi_i^T (K - lambda M) psi_j with respect to the coordinates of the vertices, with psi and
// lambda constant, for the pencil of elastic/shell.h. Returns a matrix (3 v + c) x pairs. `psi`: unknowns x
// modes.
//
// If i = j, psi_i is mass-normalised and lambda is its eigenvalue, this is the derivative of the eigenvalue
// (Fox and Kapoor 1968), or, within a cluster, of this Rayleigh quotient. Computed element by element, by
// forward-mode differentiation of strains. O(triangles (modes + pairs)). Equal to the last bit for any number
// of threads. Throws Cancelled.
Eigen::MatrixXd shellSensitivity(const ThinShell& shell, const Eigen::MatrixXd& psi,
                                 std::span<const ModePair> pairs, const Job& job);

}  // namespace limber
