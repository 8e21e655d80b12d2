#pragma once

#include <Eigen/Core>

#include "mesh/topology.h"

namespace limber {

struct ShellMaterial {
  double thickness = 0, poisson = 0.3;  // E = rho = 1
};

// Derivatives of an eigenvalue of the shell of modes/shell.h by the vertices' coordinates:
// d lambda / d x = phi^T (dK/dx - lambda dM/dx) phi for a mass-normalised phi over all unknowns (Fox and
// Kapoor 1968), a row of 3 x vertexCount. Element by element, by forward differentiation of an element's
// energy. Exact for a simple eigenvalue; for a cluster, of this phi's Rayleigh quotient.
Eigen::VectorXd eigenvalueSensitivity(const TriangleMesh& mesh, const Topology& topology,
                                      const ShellMaterial& material, double lambda,
                                      const Eigen::Ref<const Eigen::VectorXd>& phi);

}  // namespace limber
