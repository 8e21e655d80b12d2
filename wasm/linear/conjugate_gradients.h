#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "base/job.h"

namespace limber {

// A symmetric positive definite matrix A + mu D over nodes of three unknowns each.
struct ShiftedMatrix {
  const Eigen::SparseMatrix<double>& a;  // both triangles are stored
  const Eigen::VectorXd& d;              // the diagonal of D
  double mu;
  const std::vector<uint8_t>& isFixed;  // per node: its unknowns are 0 in every solution; or empty
};

// (A + mu D)^-1 b by conjugate gradients (Hestenes and Stiefel 1952), preconditioned by the diagonal blocks
// of the nodes, until the preconditioned residual has fallen to 1e-4 of that of b or after 300 steps. Every
// step lowers the quadratic model x^T (A + mu D) x / 2 - b^T x, so that a solution cut short is one of a
// trust region (Steihaug 1983). Takes memory for six vectors. The result does not depend on the number of
// threads. Throws Cancelled.
Eigen::VectorXd conjugateGradients(const ShiftedMatrix& matrix, const Eigen::VectorXd& b, Job& job);

}  // namespace limber
