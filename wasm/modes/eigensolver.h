#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "modes/stiffness_model.h"

namespace limber {

struct EigenOptions {
  int elasticCount = 12;  // wanted, above the zero modes
  int zeroExpected = 6;   // a guess that sizes the search; what is found is measured
  double scale = 1;       // > 0: a rough size of the first elastic eigenvalue
};

// The lowest eigenpairs of K phi = lambda M phi.
struct EigenPairs {
  uint32_t zeroCount =
      0;  // eigenvalues that are 0 to rounding, counted by Ritz values and checked by inertia
  Eigen::VectorXd lambda;        // elastic ones, ascending
  Eigen::MatrixXd phi;           // unknowns x pairs, mass-normalised
  std::vector<double> residual;  // |K phi - lambda M phi| / (lambda |M phi|)
  uint64_t factorNonzeros = 0;
};

// Shift-invert Lanczos (Spectra) on M^1/2 (K - sigma M)^-1 M^1/2 over the unknowns with mass, sigma of the
// size of -lambda_1, then block inverse iteration until every residual is below 1e-8 or stops falling. A
// count of negative pivots above the last wanted pair proves that none was missed. Small problems are solved
// densely. Deterministic. Needle triangles can fill the residual with rounding (K grows with 1 / area) while
// the pair is right: above 1e-7 the caller should warn. Throws Cancelled, and std::runtime_error with a
// sentence where the inverse residual |phi - (lambda - sigma) (K - sigma M)^-1 M phi| / |phi| of a pair is
// above 1e-2.
EigenPairs solveEigenproblem(const StiffnessModel& model, const EigenOptions& options, Job& job);

}  // namespace limber
