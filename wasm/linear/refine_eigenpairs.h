#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "base/job.h"
#include "linear/eigensolver.h"
#include "linear/factorisation.h"

namespace limber {

// Finds the lowest eigenpairs of a pencil from approximations.

// Lets pencils share parts of their factorisations that differ only in rows and columns of a few unknowns,
// such as those of a body in several clampings. The first pencil provides them to all others, which take its
// shift.
struct FactorSharing {
  std::vector<std::vector<uint32_t>> unknowns;          // for each of the others, those in which it differs
  std::shared_ptr<const Factorisation> base = nullptr;  // null until the first one is factorised
  double shift = 0;                                     // of the base
};

struct RefineOptions {
  double shift = -1;                   // sigma, < 0, of the size of the first positive eigenvalue
  double tolerance = kRoughTolerance;  // on the relative error of eigenvalues, > 0
  int pairCount = 12;                  // pairs with lambda > 0 to return
  int spareCount = 0;                  // the last of them, which may still be inexact
  int largestStepCount = 4;            // >= 1
  bool residuals = true;               // whether EigenSolution::residual is computed
  std::shared_ptr<const FactorStructure> structure = nullptr;  // as in EigenOptions
  std::function<void(uint64_t bytes)> admit = nullptr;         // as in EigenOptions
  FactorSharing* sharing = nullptr;
  std::vector<uint32_t> differing =
      {};  // unknowns in whose rows and columns this pencil differs from the base
};

// Block inverse iteration with Rayleigh-Ritz from `start`, until the eigenvalues change by less than the
// tolerance. `start`: unknowns x columns, with the null space among its columns; unknowns without an entry in
// M may be 0. Takes one factorisation. It converges to the pairs that `start` approximates, without a proof
// that no pair in between is missing. Throws as solveEigenproblem.
EigenSolution refineEigenpairs(const SparsePencil& pencil, const Eigen::MatrixXd& start,
                               const RefineOptions& options, Job& job);

// The same by block Lanczos, which takes fewer steps. Pseudo-random columns in addition to `start` find the
// pairs that it lacks. Returns nothing if a pair that has to be exact has not converged, if there is no spare
// pair, or if memory is short. Vectors are as accurate as their eigenvalues in the mass norm, but not in
// energy: they keep more of the high-frequency error of `start`. `largestStepCount` and `admit` are not read;
// `sharing` and `differing` are only read here. A factorisation is shared if memory for another one is left.
std::optional<EigenSolution> refineLowestEigenpairs(const SparsePencil& pencil, const Eigen::MatrixXd& start,
                                                    const RefineOptions& options, Job& job);

}  // namespace limber
