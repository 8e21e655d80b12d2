#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/job.h"
#include "linear/factor_structure.h"
#include "linear/stiffness_model.h"

namespace limber {

// K - shift M = P L D L^T P^T, multifrontal (Duff and Reid 1983) with dense fronts. No pivoting: for a
// negative shift the matrix is positive definite; for others the signs of D give the inertia (Sylvester). The
// model must outlive it. Results do not depend on the number of threads.
class Factorisation {
 public:
  // Order and structure, for any number of shifts. Throws Cancelled.
  Factorisation(const StiffnessModel& model, Job& job);
  // With a structure that was found before, of this model or of one that differs in numbers alone.
  Factorisation(const StiffnessModel& model, std::shared_ptr<const FactorStructure> structure);

  // Numbers, 8 bytes a nonzero. Reports progress within the current phase; throws Cancelled, or
  // std::runtime_error where a pivot is not finite.
  void factorise(double shift, Job& job);

  // x := (K - shift M)^-1 x; the columns of a matrix cost far less together than one by one.
  // Throws Cancelled.
  void solve(Eigen::VectorXd& x, const Job& job) const;
  void solve(Eigen::MatrixXd& x, const Job& job) const;

  // How many eigenvalues of (K, M) lie below the shift.
  uint32_t negativePivots() const;
  const FactorStructure& structure() const { return *structure_; }

 private:
  using Front = FactorStructure::Front;
  using Task = FactorStructure::Task;
  using Room = std::vector<double>;  // for the rows of a front's boundary, one for each thread
  struct Progress;

  void factoriseFront(uint32_t f, double shift, uint32_t* localRow, Job& job);
  void assemble(const Front& front, double shift, uint32_t* localRow);
  template <class Rows>
  void solveRows(Rows& y, const Job& job) const;
  template <class Rows>
  void forward(const Front& front, Rows& y, Room& room) const;
  template <class Rows>
  void backward(const Front& front, Rows& y, Room& room) const;

  const StiffnessModel& model_;
  std::shared_ptr<const FactorStructure> structure_;
  Eigen::VectorXd values_, diagonal_;     // L without its diagonal of ones; D by position
  std::vector<Eigen::MatrixXd> updates_;  // of fronts whose parent has not taken it yet, lower triangle
};

}  // namespace limber
