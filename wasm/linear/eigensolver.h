#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "base/job.h"
#include "linear/eigen_solution.h"
#include "linear/factor_structure.h"
#include "linear/sparse_pencil.h"

namespace limber {

// The lowest eigenpairs of K phi = lambda M phi for a sparse symmetric pencil with K positive semidefinite.
//
// Method of solveEigenproblem:
// 1. Shift-invert Lanczos (Lanczos 1950; implicitly restarted, by Spectra) on M^1/2 (K - sigma M)^-1 M^1/2
//    over the unknowns with an entry in M, from a fixed start vector. Nothing is deflated: zero eigenvalues
//    are found like all others. A rough search tries block Lanczos from 16 fixed vectors first, and falls
//    back to this method if that does not converge.
// 2. Shift rule: sigma is negative, so K - sigma M is positive definite and needs no pivoting. The first
//    shift is -EigenOptions::scale. If it is not between 0.005 and 15 times the first positive eigenvalue
//    lambda_1, the search is repeated with sigma = -lambda_1 / 2. If every pair found is below 1e-4 |sigma|
//    and counts as zero, inertia shows why. If some eigenvalues are above 1e-8 |sigma|, the shift is
//    too large to tell them from zero and becomes 1e-4 sigma. If none is, all of them are zero, and there are
//    more zeros than pairs sought: a positive shift between them and lambda_1 then finds the pairs above
//    them.
// 3. Block inverse iteration with Rayleigh-Ritz until the residuals are small or stop falling. A rough search
// that has converged skips this step.
// 4. Completeness by Sylvester's law of inertia: the negative pivots of K - s M, with s in a gap above the
//    last wanted pair (the first of 1 %, or else the widest), count the eigenvalues below s. If some are
//    missing, those that are zero are counted with s below lambda_1, and if the search has missed members of
//    a cluster, a second search, orthogonal to the known pairs, adds them.
// Pencils with at most 120 entries in M are solved densely.
//
// The result is deterministic and does not depend on the number of threads. Cost: two or three factorisations
// and some tens of solves.

// The relative error of eigenvalues that is accepted from a rough solve and a refined start.
inline constexpr double kRoughTolerance = 1e-4;

struct EigenOptions {
  int pairCount = 12;       // wanted pairs with lambda > 0, >= 1
  int expectedNullity = 6;  // an estimate of the number of zero eigenvalues; sizes the search; >= 0
  double scale = 1;         // a rough estimate of the first positive eigenvalue, > 0
  // The structure of this pencil or of one with the same pattern, if already known.
  std::shared_ptr<const FactorStructure> structure = nullptr;
  bool isRough = false;  // errors of kRoughTolerance are accepted, and no residuals computed
  int spareCount = 0;    // the last of the pairs, which in a rough search may be inexact; < pairCount
  // Called once with the peak bytes of the solve, before they are allocated. May throw to refuse.
  std::function<void(uint64_t bytes)> admit = nullptr;
};

// The pairs that are as accurate as the search promises: the first ones.
inline int exactCount(const EigenOptions& options) {
  return options.pairCount - (options.isRough ? options.spareCount : 0);
}

// Thrown by a search for eigenpairs that did not converge, with a sentence for the user.
class NoConvergence : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws Cancelled, NoConvergence, std::runtime_error as Factorisation::factorise does, and whatever `admit`
// throws.
EigenSolution solveEigenproblem(const SparsePencil& pencil, const EigenOptions& options, Job& job);

}  // namespace limber
