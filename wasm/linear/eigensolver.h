#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/job.h"
#include "linear/factor_structure.h"
#include "linear/stiffness_model.h"

namespace limber {

struct EigenOptions {
  int elasticCount = 12;  // wanted, above the zero modes
  int zeroExpected = 6;   // a guess that sizes the search; what is found is measured
  double scale = 1;       // > 0: a rough size of the first elastic eigenvalue
  std::shared_ptr<const FactorStructure> structure;  // of such a model, found before; null: it is found
  bool isRough = false;  // errors of 1e-4 in eigenvalues will do, and no residuals are wanted
};

// The lowest eigenpairs of K phi = lambda M phi.
struct EigenPairs {
  uint32_t zeroCount = 0;        // eigenvalues that are 0 to rounding
  Eigen::VectorXd lambda;        // elastic ones, ascending
  Eigen::MatrixXd phi;           // unknowns x pairs, mass-normalised
  std::vector<double> residual;  // |K phi - lambda M phi| / (lambda |M phi|), all unknowns
  // |phi - (lambda - sigma) (K - sigma M)^-1 M phi| / |phi| over the unknowns with mass (0 where solved
  // densely).
  std::vector<double> inverseResidual;
  uint64_t factorNonzeros = 0;
};

// Shift-invert Lanczos (Spectra) on M^1/2 (K - sigma M)^-1 M^1/2 over the unknowns with mass, sigma negative
// and of the size of the first elastic eigenvalue, then block inverse iteration until residuals stop falling.
// The zero modes are searched for like all others, nothing is deflated. The negative pivots of K - s M, s in
// the widest gap above the last wanted pair, count the eigenvalues below: pairs of clusters that the search
// missed are added until all are there. Small problems are solved densely. Deterministic.
//
// Needle triangles can fill the residual with rounding while the pair is right: above 1e-7 the caller should
// warn. Throws Cancelled, and std::runtime_error with a sentence where the inverse residual of a pair is
// above 1e-2.
EigenPairs solveEigenproblem(const StiffnessModel& model, const EigenOptions& options, Job& job);

struct RefineOptions {
  double shift = -1;        // < 0, of the size of the first elastic eigenvalue
  double tolerance = 1e-4;  // on the relative error of eigenvalues
  int elasticCount = 12;    // returned
  int spareCount = 0;       // of these, the last ones, which may still be inexact
  int largestStepCount = 4;
  bool residuals = true;                             // of the pairs are wanted too
  std::shared_ptr<const FactorStructure> structure;  // as in EigenOptions
};

// Block inverse iteration from `start` (unknowns x columns, the zero modes among them; massless unknowns may
// be 0), until the eigenvalues stand. It needs one factorisation and finds what `start` approximates; nothing
// proves that no pair is missing. Residuals are what they are: not those of an exact solve. Throws Cancelled.
EigenPairs refineEigenpairs(const StiffnessModel& model, const Eigen::MatrixXd& start,
                            const RefineOptions& options, Job& job);

}  // namespace limber
