#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "modes/stiffness_model.h"

namespace limber {

// K - shift M = P L D L^T P^T, multifrontal (Duff and Reid 1983) over a nested dissection, dense fronts, no
// pivoting: for a negative shift the matrix is positive definite; for others the pivots' signs give the
// inertia (Sylvester). The model must outlive it. Results do not depend on the number of threads.
class Factorisation {
 public:
  // Order and structure, for any number of shifts. O(nonzeros of L) integers at the most.
  explicit Factorisation(const StiffnessModel& model);

  // Numbers. Reports progress within the current phase; throws Cancelled, or std::runtime_error where a pivot
  // is not finite.
  void factorise(double shift, Job& job);

  // x := (K - shift M)^-1 x.
  void solve(Eigen::VectorXd& x) const;

  // How many eigenvalues of (K, M) lie below the shift.
  uint32_t negativePivots() const;
  // Entries of L below and on the diagonal.
  uint64_t nonzeros() const;

 private:
  // A dense block of rows `positions` (pivots first) over the pivots' columns.
  struct Front {
    uint32_t firstPivot = 0, pivotCount = 0;
    std::vector<uint32_t> boundary;  // positions after the pivots, ascending
    std::vector<uint32_t> children;
    Eigen::MatrixXd factor;  // unit lower, (pivots + boundary) x pivots, D apart
    Eigen::MatrixXd update;  // lower, boundary x boundary, until the parent has taken it
    double work = 0;
  };

  void buildFronts();
  void factoriseFront(Front& front, double shift, Job& job);
  void assemble(const Front& front, double shift, Eigen::MatrixXd& dense) const;

  const StiffnessModel& model_;
  std::vector<uint32_t> unknownAt_, positionOf_;  // elimination position <-> unknown
  std::vector<Front> fronts_;                     // children before parents
  std::vector<std::vector<uint32_t>> levels_;     // fronts by depth, the deepest level first
  Eigen::VectorXd diagonal_;                      // D by position
};

}  // namespace limber
