#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "linear/mode_basis.h"

namespace limber {

// Pairs with a larger inverse residual must not be used.
inline constexpr double kTrustedInverseResidual = 1e-2;

// Eigenpairs as a solver returns them, with measures of their accuracy.
struct EigenSolution {
  // Eigenvalues that are 0 to rounding; their vectors are not kept. For a search from scratch all of them,
  // with multiplicity; for a refinement those that its start represents.
  uint32_t nullity = 0;
  ModeBasis basis;  // the pairs with lambda > 0; fewer than wanted if there are no more
  // Per pair, over all unknowns: |K phi - lambda M phi| / (lambda |M phi|). With needle elements rounding can
  // dominate it although the pair is accurate: above 1e-7 the caller should warn.
  std::vector<double> residual;
  // Per pair, over the unknowns with an entry in M: |phi - (lambda - sigma) (K - sigma M)^-1 M phi| / |phi|.
  // The relative error of the eigenvalue is of the order of its square. 0 for dense solves.
  std::vector<double> inverseResidual;
  uint64_t factorNonzeros = 0;  // of L

  // Of the first `count` pairs, those whose inverse residual is at most kTrustedInverseResidual.
  size_t trustedCount(size_t count) const {
    return static_cast<size_t>(std::count_if(inverseResidual.begin(),
                                             inverseResidual.begin() + static_cast<ptrdiff_t>(count),
                                             [](double r) { return r <= kTrustedInverseResidual; }));
  }
};

}  // namespace limber
