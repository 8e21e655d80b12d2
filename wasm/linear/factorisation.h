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
// Usage: construct, factorise(shift), then solve() any number of times. The pencil must exist while this
// factorises. Results are equal to the last bit for any number of threads.
//
// A pencil that differs from another one only in the rows and columns of a few unknowns, such as that of a
// clamped body, can take the fronts that these do not touch from its factorisation:
//   auto base = std::make_shared<Factorisation>(pencil, structure);
//   base->keepFor(unknowns);
//   base->factorise(shift, job);
//   Factorisation other(changedPencil, base, unknowns);
//   other.factorise(shift, job);
// The result is equal to that of a factorisation of its own, to the last bit.
class Factorisation {
 public:
  // Computes the structure, which is reused for any number of shifts. Throws Cancelled.
  Factorisation(const SparsePencil& pencil, Job& job);
  // Takes a structure that was found for this pencil or for one that differs from it only in values.
  Factorisation(const SparsePencil& pencil, std::shared_ptr<const FactorStructure> structure);
  // Shares fronts of `base`, which was factorised after a call of keepFor with these unknowns.
  Factorisation(const SparsePencil& pencil, std::shared_ptr<const Factorisation> base,
                const std::vector<uint32_t>& unknowns);

  // From the next call of factorise() on, this also keeps the updates that a pencil needs whose rows and
  // columns of these unknowns differ. Can be called for several sets of unknowns.
  void keepFor(const std::vector<uint32_t>& unknowns);

  // Computes L and D, 8 bytes per nonzero. With a base, `shift` must be its shift. Reports
  // progress within the current phase. Throws Cancelled, and std::runtime_error if a pivot is not finite.
  void factorise(double shift, Job& job);

  // x := (K - shift M)^-1 x, for one or several right-hand sides (columns). Several columns at once cost far
  // less than one by one. Throws Cancelled.
  void solve(Eigen::VectorXd& x, const Job& job) const;
  void solve(Eigen::MatrixXd& x, const Job& job) const;

  // The number of eigenvalues of (K, M) below the shift.
  uint32_t negativePivots() const;
  const FactorStructure& structure() const { return *structure_; }
  // Peak bytes of this factorisation without the pencil and the base.
  uint64_t memory() const;

 private:
  using Front = FactorStructure::Front;
  using Task = FactorStructure::Task;
  struct Progress;

  // Assigns the own fronts their parts of values_, and adds up their size and work.
  void assignOffsets();
  bool isOwn(uint32_t f) const { return isTouched_.empty() || isTouched_[f]; }
  bool isKept(uint32_t f) const { return !isKept_.empty() && isKept_[f]; }
  // The columns of L of a front, rows() x pivotCount.
  const double* valuesOf(uint32_t f) const;

  void factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job);
  void addUpdate(uint32_t child, uint32_t f, const uint32_t* localRow);
  void assemble(uint32_t f, double shift, uint32_t* localRow);
  template <class Rows>
  void solveRows(Rows& y, const Job& job) const;
  template <class Rows>
  void forward(uint32_t f, uint32_t scratch, Rows& y) const;
  template <class Rows>
  void backward(uint32_t f, uint32_t scratch, Rows& y) const;

  const SparsePencil& pencil_;
  std::shared_ptr<const FactorStructure> structure_;
  std::shared_ptr<const Factorisation> base_;  // may be null
  std::vector<bool> isTouched_;                // fronts that differ from the base's; empty without one
  std::vector<bool> isKept_;                   // fronts whose updates are kept; may be empty
  std::vector<size_t> firstValue_;             // by front, of own ones
  uint64_t valueCount_ = 0;                    // doubles that the columns of own fronts take
  double work_ = 0;                            // multiplications of own fronts
  Eigen::VectorXd values_, diagonal_;          // L without its unit diagonal, by own front; D, by position
  std::vector<Eigen::MatrixXd> updates_;  // lower triangles, of fronts whose parents have not yet added them
};

// With this structure, or with one that is found if it is null. Throws Cancelled.
std::shared_ptr<Factorisation> factorisationOf(const SparsePencil& pencil,
                                               std::shared_ptr<const FactorStructure> structure, Job& job);

}  // namespace limber
