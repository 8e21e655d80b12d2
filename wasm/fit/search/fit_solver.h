#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/job.h"
#include "linear/block_matrix.h"
#include "linear/factor_structure.h"
#include "linear/sparse_pencil.h"

namespace limber {

// The matrix A + mu D of the normal equations of a damped Gauss-Newton step (Levenberg 1944, Marquardt 1963)
// over the coordinates 3 v + axis of a mesh.
struct DampedSystem {
  const BlockMatrix& hessian;              // A, positive semidefinite
  const Eigen::VectorXd& dampingDiagonal;  // D, positive
  double damping;                          // mu > 0
};

// Solves damped systems of meshes whose vertices move while their triangles, and with them the sparsity
// pattern, stay the same: the elimination order and the structure of the factor are found once.
class FitSolver {
 public:
  // `locked`: per vertex, not 0 if it stays in place: its three unknowns are 0. The job must outlive this.
  FitSolver(const std::vector<uint8_t>& locked, Job& job);

  // (A + mu D)^-1 b for each column b of 3 vertexCount numbers; all columns share one factorisation. Throws
  // Cancelled.
  Eigen::MatrixXd solve(const DampedSystem& system, Eigen::MatrixXd columns);

 private:
  Job& job_;
  // The sparse factorisation of linear/ factorises K - sigma M of a pencil (K, M). Here the pencil is (A, D)
  // and sigma is -mu.
  SparsePencil pencil_;
  std::vector<uint32_t> lockedUnknowns_;  // ascending
  std::shared_ptr<const FactorStructure> structure_;
};

}  // namespace limber
