#pragma once

#include <Eigen/Core>

#include "linear/sparse_pencil.h"

namespace limber {

// K (phi + low) - lambda M (phi + low), evaluated with twice the digits of a double and rounded once at the
// end. A residual in plain doubles contains the rounding error eps |K| |phi| of phi itself, which for small
// or thin elements is not small compared to lambda |M phi|.
Eigen::VectorXd extendedResidual(const SparsePencil& pencil, double lambda, const Eigen::VectorXd& phi,
                                 const Eigen::VectorXd& low);

}  // namespace limber
