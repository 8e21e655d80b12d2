#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "modes/stiffness_model.h"

namespace limber {

// K - shift M = P L D L^T P^T, multifrontal (Duff and Reid 1983) with dense fronts. No pivoting: for a
// negative shift the matrix is positive definite; for others the signs of D give the inertia (Sylvester). The
// model must outlive it. Results do not depend on the number of threads.
class Factorisation {
 public:
  // Order and structure, for any number of shifts. Throws Cancelled.
  Factorisation(const StiffnessModel& model, Job& job);

  // Numbers, 8 bytes a nonzero. Reports progress within the current phase; throws Cancelled, or
  // std::runtime_error where a pivot is not finite.
  void factorise(double shift, Job& job);

  // x := (K - shift M)^-1 x; the columns of a matrix cost far less together than one by one.
  // Throws Cancelled.
  void solve(Eigen::VectorXd& x, const Job& job) const;
  void solve(Eigen::MatrixXd& x, const Job& job) const;

  // How many eigenvalues of (K, M) lie below the shift.
  uint32_t negativePivots() const;
  // Entries of L below and on the diagonal; the zeros that are stored to make fronts larger do not count.
  uint64_t nonzeros() const;
  // Bytes that a factorisation takes beside the model, at its peak: L and the updates that wait for their
  // parents.
  uint64_t memory() const;
  // Multiplications of one factorisation, about.
  double work() const;

 private:
  // Rows: the pivots, then the boundary. Its columns of L are at values_[firstValue], rows x pivots.
  struct Front {
    uint32_t firstPivot, pivotCount;
    uint32_t firstRow, boundaryCount;  // its boundary: boundary_[firstRow ..], slot_[firstRow ..]
    size_t firstValue;
    double work;         // of its own
    double subtreeWork;  // with all below it
    std::vector<uint32_t> children;
    uint32_t rows() const { return pivotCount + boundaryCount; }
  };
  // Subtrees that threads work through on their own: fronts firstFront .. root.
  struct Task {
    uint32_t firstFront, root;
    uint32_t firstSlot;  // of what it adds to the boundary of its root
  };
  struct Progress;

  void buildFronts(const Job& job);
  void buildTasks();
  void factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job);
  void assemble(const Front& front, double shift, uint32_t* localRow);
  template <class Rows>
  void solveRows(Rows& y, const Job& job) const;
  template <class Rows>
  void forward(const Front& front, Rows& y) const;
  template <class Rows>
  void backward(const Front& front, Rows& y) const;

  const StiffnessModel& model_;
  std::vector<uint32_t> unknownAt_, positionOf_;  // elimination position <-> unknown
  std::vector<Front> fronts_;                     // children before parents, subtrees consecutive
  std::vector<uint32_t> boundary_;                // positions
  std::vector<uint32_t> slot_;                    // where a solve keeps that row while in this task
  std::vector<Task> tasks_;
  std::vector<uint32_t> top_;  // fronts above the tasks
  uint32_t slotCount_ = 0;
  size_t valueCount_ = 0;
  uint64_t storedZeros_ = 0;
  Eigen::VectorXd values_, diagonal_;     // L without its diagonal of ones; D by position
  std::vector<Eigen::MatrixXd> updates_;  // of fronts whose parent has not taken it yet, lower triangle
};

}  // namespace limber
