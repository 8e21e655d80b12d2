#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "elastic/solvers/solver_stiffness.h"
#include "fit/tune/steps/factor_range.h"
#include "fit/tune/steps/tune_problem.h"

namespace limber {

// The constraints of a body from which factors are computed.
struct TuneConstraints {
  const TriangleMesh& mesh;
  std::span<const SolverConstraint> all;  // stretch constraints first
  size_t stretchCount;
  bool tunesStretch;  // false: the factors of stretch constraints stay 1
  FactorRange stretchRange, bendRange;
};

struct GlobalFactors {
  double stretch = 1, bend = 1;
};

// One factor for each kind of constraint: the maximum a posteriori estimate of their logarithms by
// Gauss-Newton steps, with a Gaussian prior of mean 0 and standard deviation ln(10) / 2 and noise of the
// variance of the residuals. The modes thus determine the factors that they depend on; all others stay 1.
// Leaves the problem at the result. All three functions keep factors in their ranges. Throws Cancelled.
GlobalFactors tuneGlobally(TuneProblem& problem, const TuneConstraints& constraints, Job& job);

struct VertexFields {
  std::vector<double> stretch, bend;  // per vertex, mean 1
  GlobalFactors factors;              // times these
};

// Smooth fields per vertex times `start`; the factor of a constraint is the mean over its vertices. Their
// logarithms have a Gaussian prior whose correlation length is half a wavelength of the highest fitted mode,
// sqrt(area / modes), and whose variance explains half of the squared residuals that `start` leaves; the
// other half counts as noise.
VertexFields tuneFields(TuneProblem& problem, const TuneConstraints& constraints, const GlobalFactors& start,
                        Job& job);

// A factor for each constraint, starting from `start`: least-norm steps in logarithms, at most 0.7 per round,
// until the mean error of the fitted frequencies is below 0.25 % or no longer falls, in at most 20 rounds.
std::vector<double> tuneConstraints(TuneProblem& problem, const TuneConstraints& constraints,
                                    const GlobalFactors& start, Job& job);

// Expands one factor for each kind to factors on all constraints.
std::vector<double> factorsOf(const GlobalFactors& factors, const TuneConstraints& constraints);

}  // namespace limber
