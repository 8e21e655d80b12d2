#pragma once

#include <Eigen/Core>

#include "linear/stiffness_model.h"

namespace limber {

// K (phi + low) - lambda M (phi + low) in twice the precision of a double, rounded once at the end: rounding
// phi to doubles alone leaves eps |K| |phi|, which on small or thin triangles is not small against lambda |M
// phi|.
Eigen::VectorXd extendedResidual(const StiffnessModel& model, double lambda, const Eigen::VectorXd& phi,
                                 const Eigen::VectorXd& low);

}  // namespace limber
