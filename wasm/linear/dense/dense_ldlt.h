#pragma once

#include <Eigen/Core>

#include "base/job.h"

namespace limber {

// One front of a multifrontal LDL^T. `columns` holds the columns of as many pivots, lower triangle, the
// pivots' own rows first; afterwards L (the diagonal of ones is implied; what is above it is left alone),
// with D in `d`. Subtracts L D L^T of the remaining rows from the lower triangle of `update`; a little above
// the diagonal is overwritten. No pivoting: a pivot that vanishes to rounding becomes a tiny one. Checks the
// job between blocks; threads share large updates.
void partialLdlt(Eigen::Map<Eigen::MatrixXd> columns, Eigen::Ref<Eigen::VectorXd> d, Eigen::MatrixXd& update,
                 Job& job);

}  // namespace limber
