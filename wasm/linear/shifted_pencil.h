#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/factorisation.h"
#include "linear/sparse_pencil.h"

namespace limber {

// A pencil (K, M) with K - sigma M factorised, and the operations that an eigensolver needs. Unknowns with an
// entry in M are called heavy, the others massless.
class ShiftedPencil {
 public:
  // Pencil and job must outlive the object. `structure`: as in EigenOptions.
  ShiftedPencil(const SparsePencil& pencil, std::shared_ptr<const FactorStructure> structure, Job& job);
  ShiftedPencil(const SparsePencil& pencil, std::shared_ptr<Factorisation> factorisation, Job& job);

  // Factorises K - sigma M. Must be called before anything that solves. Throws Cancelled.
  void shiftTo(double sigma);
  double shift() const { return sigma_; }
  // The number of eigenvalues below lambda, from the inertia of K - lambda M. Leaves lambda as the shift.
  uint32_t countBelow(double lambda);

  // M^1/2 (K - sigma M)^-1 M^1/2 x over the heavy unknowns; many columns at once take a fraction of the time.
  Eigen::VectorXd invert(const Eigen::VectorXd& x) const;
  Eigen::MatrixXd invert(const Eigen::MatrixXd& x) const;
  // (K - sigma M)^-1 M phi over all unknowns: one step of inverse iteration for each column.
  Eigen::MatrixXd inverseStep(const Eigen::MatrixXd& phi) const;

  // Converts M^1/2 times the heavy part of vectors to vectors over all unknowns, and back. `expand` sets
  // massless unknowns to 0; for eigenvectors that is correct if `masslessAreZero`, as for clamped unknowns,
  // which have no couplings.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& heavy) const;
  Eigen::MatrixXd restrict(const Eigen::MatrixXd& phi) const;
  bool masslessAreZero() const { return masslessAreZero_; }

  // |K phi - lambda M phi| / (lambda |M phi|).
  double residual(double lambda, const Eigen::VectorXd& phi) const;
  // The same for phi plus a correction from up to `steps` steps of iterative refinement, evaluated with twice
  // the digits: the residual without the rounding of phi to doubles.
  double extendedResidual(double lambda, const Eigen::VectorXd& phi, int steps) const;
  // Per column |before - scale after| / |before|, in the mass norm.
  Eigen::VectorXd relativeChange(const Eigen::MatrixXd& before, const Eigen::MatrixXd& after,
                                 const Eigen::VectorXd& scale) const;
  // a^T M b.
  Eigen::MatrixXd massProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;

  Eigen::Index heavyCount() const { return rootMass_.size(); }
  Eigen::Index unknownCount() const { return pencil_.m.size(); }
  // Peak bytes of a factorisation and `vectorCount` vectors of all unknowns.
  uint64_t memoryWith(int vectorCount) const;
  uint64_t factorNonzeros() const { return factorisation_->structure().nonzeros(); }
  std::shared_ptr<const Factorisation> factorisation() const { return factorisation_; }
  Job& job() const { return job_; }

 private:
  template <class Columns>
  Columns invertColumns(const Columns& x) const;

  const SparsePencil& pencil_;
  std::shared_ptr<Factorisation> factorisation_;
  Job& job_;
  double sigma_ = 0;
  std::vector<Eigen::Index> heavy_;
  bool masslessAreZero_ = true;  // in every eigenvector
  Eigen::VectorXd rootMass_;     // square roots of M's entries, of the heavy unknowns
};

}  // namespace limber
