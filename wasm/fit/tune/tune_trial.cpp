#include "fit/tune/tune_trial.h"

#include "fit/tune/motion_trial.h"
#include "mesh/topology.h"

namespace limber {

namespace {

struct NoisyTrial {
  MotionTrial& trial;
  double noise;  // % of the diagonal: smaller differences of deviations are not significant
};

// The candidate that deviates least, and its deviation; nothing if none can be moved. Of candidates that are
// equal within the noise it is the first.
struct BestCandidate {
  size_t index = 0;
  std::optional<double> deviation = {};
};
BestCandidate bestOf(const std::vector<TuneCandidate>& candidates, MovingBody body, NoisyTrial noisy,
                     Job& job) {
  auto& [trial, noise] = noisy;
  const SolverConstants untouched = body.constants;
  BestCandidate best;
  for (size_t i = 0; i < candidates.size(); ++i) {
    body.constants = untouched;
    body.constants.stretch *= candidates[i].stretch;
    body.constants.secondStretch *= candidates[i].stretch;
    body.constants.bend *= candidates[i].bend;
    body.factors = candidates[i].factors;
    const std::optional<double> deviation = trial.deviationOf(body, job);
    if (!deviation || (best.deviation && *deviation >= *best.deviation - noise)) continue;
    best = {i, deviation};
  }
  return best;
}

}  // namespace

TrialOutcome tryMotion(const TrialBodies& bodies, const std::vector<TuneCandidate>& candidates, Job& job) {
  const auto& [original, result, options, masses] = bodies;
  if (options.model.bend == BendElement::Morley && options.tune != TuneKind::Global)
    return {.refusal = "the shell moves with one factor of each kind alone"};
  const Topology originalTopology = buildTopology(original), topology = buildTopology(result);
  MotionTrial trial({original, originalTopology, options.original, {options.pinnedOriginal, {}}, {}, {}},
                    options.model, job);
  if (!trial.refusal().empty()) return {.refusal = trial.refusal()};
  const MovingBody body{result, topology, options.result, {options.pinnedResult, {}}, masses, {}};
  const std::optional<double> untouched = trial.deviationOf(body, job);
  const double noise = trial.noiseFloor();
  const BestCandidate best = untouched ? bestOf(candidates, body, {trial, noise}, job) : BestCandidate{};
  if (!best.deviation)
    return {.refusal = "the time steps of the coarse mesh do not converge or take too long"};
  const double tuned = *best.deviation;
  return {
      .motion = TunedMotion{trial.scene(), *untouched, tuned, noise,
                            tuned <= *untouched + noise ? KeptParameters::Tuned : KeptParameters::Untouched},
      .best = best.index};
}

}  // namespace limber
