#pragma once

#include <Eigen/Core>

#include "base/job.h"

namespace limber {

// Eliminates the first `pivots` unknowns of the symmetric matrix whose lower triangle is `a`: afterwards the
// first columns hold L (unit diagonal implied), `d` holds D, and the lower right corner holds the Schur
// complement. No pivoting: a pivot that vanishes to rounding is replaced by a tiny one. Checks the job
// between blocks; threads share the large updates.
void partialLdlt(Eigen::MatrixXd& a, Eigen::Index pivots, Eigen::Ref<Eigen::VectorXd> d, Job& job);

}  // namespace limber
