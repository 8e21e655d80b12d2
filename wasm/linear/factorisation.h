#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/job.h"
#include "linear/factor_structure.h"
#include "linear/sparse_pencil.h"

namespace limber {

// A sparse direct solver for symmetric matrices: K - shift M = P L D L^T P^T with the permutation P of nested
// dissection, L unit lower triangular and D diagonal.
//
// The method is multifrontal (Duff and Reid 1983; Liu 1992): supernodes become dense fronts, each front adds
// the updates of its children, eliminates its pivots and passes an update on to its parent. Subtrees are
// distributed to threads as tasks; the columns of large fronts, and in solves their right-hand sides, are
// divided among threads.
//
// There is no pivoting. For a negative shift the matrix is positive definite and needs none. For other shifts
// the factor may be inaccurate near an eigenvalue, but by Sylvester's law of inertia the signs of D still
// count the eigenvalues below the shift.
//
// Usage: construct, factorise(shift), then solve() any number of times. The pencil must outlive the object.
// Results are equal to the last bit for any number of threads.
class Factorisation {
 public:
  // Computes the structure, which is reused for any number of shifts. Throws Cancelled.
  Factorisation(const SparsePencil& pencil, Job& job);
  // Takes a structure that was found for this pencil or for one that differs from it only in values.
  Factorisation(const SparsePencil& pencil, std::shared_ptr<const FactorStructure> structure);

  // Computes L and D, 8 bytes per nonzero. Reports progress within the current phase. Throws Cancelled, and
  // std::runtime_error if a pivot is not finite.
  void factorise(double shift, Job& job);

  // x := (K - shift M)^-1 x, for one or several right-hand sides (columns). Several columns at once cost far
  // less than one by one. Throws Cancelled.
  void solve(Eigen::VectorXd& x, const Job& job) const;
  void solve(Eigen::MatrixXd& x, const Job& job) const;

  // The number of eigenvalues of (K, M) below the shift.
  uint32_t negativePivots() const;
  const FactorStructure& structure() const { return *structure_; }

 private:
  using Front = FactorStructure::Front;
  using Task = FactorStructure::Task;
  struct Progress;

  void factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job);
  void assemble(const Front& front, double shift, uint32_t* localRow);
  template <class Rows>
  void solveRows(Rows& y, const Job& job) const;
  template <class Rows>
  void forward(const Front& front, uint32_t scratch, Rows& y) const;
  template <class Rows>
  void backward(const Front& front, uint32_t scratch, Rows& y) const;

  const SparsePencil& pencil_;
  std::shared_ptr<const FactorStructure> structure_;
  Eigen::VectorXd values_, diagonal_;     // L without its unit diagonal, by front; D, by position
  std::vector<Eigen::MatrixXd> updates_;  // lower triangles, of fronts whose parents have not yet added them
};

}  // namespace limber
