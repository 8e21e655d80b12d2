#pragma once

#include <Eigen/Core>
#include <span>

#include "base/job.h"
#include "mesh/topology.h"

namespace limber {

struct ShellMaterial {
  double thickness = 0, poisson = 0.3;  // E = rho = 1
};

// An entry of a reduced stiffness matrix: psi_i^T (K - lambda M) psi_j.
struct ModePair {
  int i = 0, j = 0;
  double lambda = 0;
};

// Derivatives of psi_i^T (K - lambda M) psi_j by the vertices' coordinates, with psi and lambda held, for the
// shell of modes/shell.h: a column of 3 x vertexCount for each pair. `psi`: unknowns x modes. For i = j, a
// mass-normalised mode and its own lambda that is the eigenvalue's derivative (Fox and Kapoor 1968; of a
// cluster, of this Rayleigh quotient). Element by element, by forward differentiation of an element's
// strains. The same for any number of threads. Throws Cancelled.
Eigen::MatrixXd shellSensitivity(const TriangleMesh& mesh, const Topology& topology,
                                 const ShellMaterial& material, const Eigen::MatrixXd& psi,
                                 std::span<const ModePair> pairs, const Job& job);

}  // namespace limber
