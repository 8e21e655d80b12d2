#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/block_matrix.h"

namespace limber {

// A symmetric positive definite matrix A + mu D over nodes of three unknowns each.
struct ShiftedMatrix {
  const BlockMatrix& a;
  const Eigen::VectorXd& d;  // the diagonal of D
  double mu;
  const std::vector<uint8_t>& isFixed;  // per node: its unknowns are 0 in every solution; or empty
};

// (A + mu D)^-1 b for each column b by conjugate gradients (Hestenes and Stiefel 1952), preconditioned by the
// diagonal blocks of the nodes, until the preconditioned residual has fallen to a hundredth of that of b or
// after 300 steps. Every step lowers the quadratic model x^T (A + mu D) x / 2 - b^T x, so that an early stop
// gives a solution for a smaller trust region (Steihaug 1983). Up to three columns are solved together,
// because reading the matrix takes most of the time; each takes memory for five vectors. The result does not
// depend on the number of threads. Throws Cancelled.
Eigen::MatrixXd conjugateGradients(const ShiftedMatrix& matrix, const Eigen::MatrixXd& b, Job& job);

}  // namespace limber
