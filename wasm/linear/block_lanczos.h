#pragma once

#include "linear/mode_basis.h"
#include "linear/shifted_pencil.h"

namespace limber {

// Blocks of vectors that are allocated in addition to the basis.
inline constexpr Eigen::Index kBlocksBesideBasis = 3;

struct BlockLanczosOptions {
  Eigen::Index pairs;        // of the lowest eigenvalues to return, >= exact
  Eigen::Index exact;        // of these, the number that must converge, >= 1
  double tolerance;          // on the roots of relative errors of their eigenvalues, > 0
  Eigen::Index mostVectors;  // of the basis, >= the columns of the start
  int leastBlocks = 1;       // before the search ends, so that random columns find what a good start lacks
};

struct BlockLanczosPairs : ModeBasis {  // phi over the heavy unknowns, M^1/2 times the vectors
  Eigen::VectorXd inverseResidual;
  bool hasConverged = false;
};

// Pseudo-random vectors of similar lengths, always the same for the same sizes. They have no symmetry that
// could hide an eigenvector.
Eigen::MatrixXd randomColumns(Eigen::Index size, Eigen::Index columns);

// The lowest eigenpairs of a shifted pencil, zeros among them, by block Lanczos with full orthogonalisation
// and without restarts (Golub and Underwood 1977), from the columns of `start`, over the heavy unknowns. A
// solve for a block of vectors reads the factor once, so it takes a fraction of the time of single solves. It
// finds an eigenvector only if a column of the start has a part along it, as a pseudo-random one has, and
// does not prove that no pair is missing. Throws Cancelled.
BlockLanczosPairs blockLanczos(const ShiftedPencil& pencil, const Eigen::MatrixXd& start,
                               const BlockLanczosOptions& options);

}  // namespace limber
