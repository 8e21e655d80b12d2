#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/factorisation.h"
#include "linear/stiffness_model.h"

namespace limber {

// (K, M) of a model with K - sigma M factorised: all that the search for eigenpairs asks of them. Unknowns
// with mass are called heavy.
class Pencil {
 public:
  // Model and job must outlive it. `structure`: as in EigenOptions.
  Pencil(const StiffnessModel& model, std::shared_ptr<const FactorStructure> structure, Job& job);

  // Factorises K - sigma M; to be called before anything that solves.
  void shiftTo(double sigma);
  double shift() const { return sigma_; }
  // How many eigenvalues lie below lambda, by the inertia of K - lambda M. Afterwards that is the shift.
  uint32_t countBelow(double lambda);

  // M^1/2 (K - sigma M)^-1 M^1/2 x over the heavy unknowns.
  Eigen::VectorXd invert(const Eigen::Ref<const Eigen::VectorXd>& x) const;
  // (K - sigma M)^-1 M phi over all unknowns: a step of inverse iteration for each column.
  Eigen::MatrixXd inverseStep(const Eigen::MatrixXd& phi) const;

  // Between vectors over all unknowns and M^1/2 times their heavy part; the massless part becomes 0.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& heavy) const;
  Eigen::MatrixXd restrict(const Eigen::MatrixXd& phi) const;

  // |K phi - lambda M phi| / (lambda |M phi|).
  double residual(double lambda, const Eigen::VectorXd& phi) const;
  // The same of phi plus a correction of up to some steps, evaluated in twice the precision: what is left of
  // the residual when rounding phi to doubles does not count.
  double extendedResidual(double lambda, const Eigen::VectorXd& phi, int steps) const;
  // a^T M b.
  Eigen::MatrixXd massProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;

  Eigen::Index heavyCount() const { return rootMass_.size(); }
  // Throws std::runtime_error where a factorisation and `vectorCount` vectors of all unknowns would not fit.
  void requireMemoryFor(int vectorCount) const;
  uint64_t factorNonzeros() const { return factorisation_.structure().nonzeros(); }
  Job& job() const { return job_; }

 private:
  const StiffnessModel& model_;
  Factorisation factorisation_;
  Job& job_;
  double sigma_ = 0;
  std::vector<Eigen::Index> heavy_;
  Eigen::VectorXd rootMass_;  // of the heavy unknowns
};

}  // namespace limber
