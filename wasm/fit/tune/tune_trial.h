#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/job.h"
#include "fit/tune/tune_options.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The input of a trial, which chooses factors by the motion itself.
struct TrialBodies {
  const TriangleMesh& original;
  const TriangleMesh& result;
  const TuneOptions& options;
  const std::vector<double>& masses;  // tuned, kg per vertex of the result
};

// Candidate parameters, in order of preference if their motions are equal.
struct TuneCandidate {
  double stretch = 1, bend = 1;      // on all constraints of a kind
  std::vector<double> factors = {};  // per constraint of the result, times these; empty: 1
};

struct TrialOutcome {
  std::optional<TunedMotion> motion = {};  // `tuned`: of the best candidate
  size_t best = 0;           // the candidate that deviates least; undefined if the untuned result is kept
  std::string refusal = {};  // why there is no `motion`, as a clause; else empty
};

// Moves original, the result with factors of 1, and the result with each candidate. Deviations that differ by
// no more than the noise floor of the trial are equal: of equal ones the first candidate is best, and tuned
// factors, which fit the frequencies, are kept. There is no motion if there is no trial (see
// MotionTrial::refusal; Morley's element only moves with one factor for each kind), or if the untuned result
// or all candidates cannot be moved. Throws Cancelled.
TrialOutcome tryMotion(const TrialBodies& bodies, const std::vector<TuneCandidate>& candidates, Job& job);

}  // namespace limber
