#pragma once

#include "linear/mode_basis.h"
#include "linear/shifted_pencil.h"

namespace limber {

// Blocks of vectors that are allocated in addition to the basis.
inline constexpr Eigen::Index kBlocksBesideBasis = 3;

struct BlockLanczosOptions {
  Eigen::Index pairs;        // of the lowest eigenvalues to return, >= exact
  Eigen::Index exact;        // of these, the number that must converge, >= 1
  double tolerance;          // on their inverse residuals, > 0
  Eigen::Index mostVectors;  // of the basis, >= the columns of the start
};

struct BlockLanczosPairs : ModeBasis {  // phi over the heavy unknowns, M^1/2 times the vectors
  Eigen::VectorXd inverseResidual;
  bool hasConverged = false;
};

// The lowest eigenpairs of a shifted pencil, zeros among them, by block Lanczos with full orthogonalisation
// and without restarts (Golub and Underwood 1977), from the columns of `start`, over the heavy unknowns. A
// solve for a block of vectors reads the factor once, so it takes a fraction of the time of single solves. It
// does not prove that no pair is missing. Throws Cancelled.
BlockLanczosPairs blockLanczos(const ShiftedPencil& pencil, const Eigen::MatrixXd& start,
                               const BlockLanczosOptions& options);

}  // namespace limber
