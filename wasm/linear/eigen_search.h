#pragma once

#include "linear/eigen_solution.h"
#include "linear/mode_basis.h"
#include "linear/shifted_pencil.h"

namespace limber {

// What the searches for eigenpairs share.

// The eigenpairs known so far, ascending, including those of zero eigenvalues.
struct EigenSearch : ModeBasis {
  Eigen::VectorXd inverseResidual = {};
  Eigen::Index hiddenZeros = 0;  // zero eigenvalues that inertia counts and that no pair stands for
};

// Eigenvalues below this times |sigma| count as zero.
inline constexpr double kZeroRatio = 1e-4;

// How many pairs have an eigenvalue of 0, found with the shift sigma.
Eigen::Index zeroPairs(const EigenSearch& search, double sigma);

// One step of block inverse iteration with Rayleigh-Ritz. For x = (K - sigma M)^-1 M phi we have
// K x = M phi + sigma M x, so x^T K x needs no product with K, whose largest entries would only add rounding.
// The inverse residual that is stored belongs to the pairs before the step.
void inverseIterate(const ShiftedPencil& pencil, EigenSearch& search);

// How many eigenvalues inertia counts beyond those of the search and its hidden zeros, up to a gap after the
// last wanted one. Shifts the pencil.
int missingPairs(ShiftedPencil& pencil, const EigenSearch& search, Eigen::Index lastWanted);

// Drops the first `zeros` pairs and keeps up to `pairCount` of the others.
EigenSolution collectPairs(const EigenSearch& search, Eigen::Index zeros, int pairCount);

}  // namespace limber
