#pragma once

#include "linear/eigen_solution.h"
#include "linear/mode_basis.h"
#include "linear/shifted_pencil.h"

namespace limber {

// Shared steps of the searches for eigenpairs.

// The eigenpairs known so far, ascending, including those of zero eigenvalues.
struct EigenSearch : ModeBasis {
  Eigen::VectorXd inverseResidual = {};
  Eigen::Index hiddenZeros = 0;  // zero eigenvalues that inertia counts and that no pair represents
};

// Eigenvalues below this times |sigma| count as zero.
inline constexpr double kZeroRatio = 1e-4;

// The number of pairs with an eigenvalue of 0, found with the shift sigma.
Eigen::Index zeroPairs(const EigenSearch& search, double sigma);

// One step of block inverse iteration with Rayleigh-Ritz. For x = (K - sigma M)^-1 M phi we have
// K x = M phi + sigma M x, so x^T K x needs no product with K, whose large entries would only add rounding
// errors. The inverse residual that is stored belongs to the pairs before the step.
void inverseIterate(const ShiftedPencil& pencil, EigenSearch& search);

// The number of eigenvalues that inertia counts in addition to those of the search and its hidden zeros, up
// to a gap after the last wanted one. Changes the shift of the pencil.
int missingPairs(ShiftedPencil& pencil, const EigenSearch& search, Eigen::Index lastWanted);

// Drops the first `zeros` pairs and keeps up to `pairCount` of the others.
EigenSolution collectPairs(const EigenSearch& search, Eigen::Index zeros, int pairCount);

}  // namespace limber
