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
//    are found like all others. A rough search is block Lanczos from 16 fixed vectors first, and this where
//    that does not converge.
// 2. Shift rule: sigma is negative, so K - sigma M is positive definite and needs no pivoting. The first
//    shift is -EigenOptions::scale. If it is not between 0.005 and 15 times the first positive eigenvalue
//    lambda_1, the search is repeated with sigma = -lambda_1 / 2. Where every pair found is below 1e-4
//    |sigma| and counts as zero, inertia tells why. If some eigenvalues are above 1e-8 |sigma|, the shift is
//    too large to tell them from zero and becomes 1e-4 sigma. If none is, all of them are zero, and more than
//    were sought: then a positive shift between them and lambda_1 finds what is above them.
// 3. Block inverse iteration with Rayleigh-Ritz until the residuals are small or stop falling. A rough search
//    that has converged goes without it.
// 4. Completeness by Sylvester's law of inertia: the negative pivots of K - s M, with s in a gap above the
//    last wanted pair (the first of 1 %, or else the widest), count the eigenvalues below s. If some are
//    missing, those that are zero are counted with s below lambda_1, and if the search has missed members of
//    a cluster, a second search orthogonal to the known pairs adds them.
// Pencils with at most 120 entries in M are solved densely.
//
// The result is deterministic and does not depend on the number of threads. Cost: two or three factorisations
// and some tens of solves.

// The relative error of eigenvalues that a rough solve and a refined start may have.
inline constexpr double kRoughTolerance = 1e-4;

struct EigenOptions {
  int pairCount = 12;       // wanted pairs with lambda > 0, >= 1
  int expectedNullity = 6;  // a guess of the number of zero eigenvalues, which sizes the search; >= 0
  double scale = 1;         // a rough size of the first positive eigenvalue, > 0
  // The structure of this pencil or of one with the same pattern, if it is known already.
  std::shared_ptr<const FactorStructure> structure = nullptr;
  bool isRough = false;  // errors of kRoughTolerance will do, and no residuals are wanted
  // Called once with the bytes that the solve takes at its peak, before it takes them. May throw to refuse.
  std::function<void(uint64_t bytes)> admit = nullptr;
};

// A search for eigenpairs that did not converge, in a sentence for the user.
class NoConvergence : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws Cancelled, NoConvergence, std::runtime_error as Factorisation::factorise, and whatever `admit`
// throws.
EigenSolution solveEigenproblem(const SparsePencil& pencil, const EigenOptions& options, Job& job);

}  // namespace limber
