#pragma once

#include <Eigen/Core>

#include "base/job.h"

namespace limber {

// Eliminates the pivots of one dense front: a partial LDL^T factorisation.
//
// `columns` (rows x pivots) holds the lower triangle of the pivots' columns, the pivots' own rows first. It
// is overwritten with L, whose unit diagonal is implied. `d` receives D. L D L^T of the remaining rows is
// subtracted from the lower triangle of `update`. What is above a diagonal is not read, but some entries
// just above it are overwritten. No pivoting: a zero pivot is replaced by 1e-200. Threads share
// large updates. Throws Cancelled.
void partialLdlt(Eigen::Map<Eigen::MatrixXd> columns, Eigen::Ref<Eigen::VectorXd> d, Eigen::MatrixXd& update,
                 Job& job);

}  // namespace limber
