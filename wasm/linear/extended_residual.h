#pragma once

#include <Eigen/Core>

#include "linear/sparse_pencil.h"

namespace limber {

// K (phi + low) - lambda M (phi + low), evaluated with twice the digits of a double and rounded once at the
// end. A residual in plain doubles carries the rounding eps |K| |phi| of phi itself, which on small or thin
// elements is not small against lambda |M phi|.
Eigen::VectorXd extendedResidual(const SparsePencil& pencil, double lambda, const Eigen::VectorXd& phi,
                                 const Eigen::VectorXd& low);

}  // namespace limber
