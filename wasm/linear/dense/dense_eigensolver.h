#pragma once

#include <Eigen/Core>

#include "linear/stiffness_model.h"

namespace limber {

// All eigenpairs of a small problem, ascending; massless unknowns are condensed out and follow. phi is
// mass-normalised.
struct DensePairs {
  Eigen::VectorXd lambda;
  Eigen::MatrixXd phi;  // unknowns x pairs
};
DensePairs solveDensely(const StiffnessModel& model);

}  // namespace limber
