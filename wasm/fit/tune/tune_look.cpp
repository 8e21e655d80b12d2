#include "fit/tune/tune_look.h"

#include "fit/tune/motion_look.h"
#include "mesh/topology.h"

namespace limber {

std::optional<LookOutcome> lookAtMotion(const LookedAt& bodies, const std::vector<TuneCandidate>& candidates,
                                        Job& job) {
  const auto& [original, result, options, masses] = bodies;
  if (options.model.bend == BendElement::Morley && options.tune != TuneKind::Global) return std::nullopt;
  const Topology originalTopology = buildTopology(original), topology = buildTopology(result);
  MotionLook look({original, originalTopology, options.original, {options.pinnedOriginal, {}}, {}, {}},
                  options.model, job);
  if (!look.refusal().empty()) return std::nullopt;
  MovingBody body{result, topology, options.result, {options.pinnedResult, {}}, masses, {}};
  const std::optional<double> untouched = look.deviationOf(body, job);
  if (!untouched) return std::nullopt;
  std::optional<double> least;
  LookOutcome outcome;
  for (size_t i = 0; i < candidates.size(); ++i) {
    body.constants = options.result;
    body.constants.stretch *= candidates[i].stretch;
    body.constants.secondStretch *= candidates[i].stretch;
    body.constants.bend *= candidates[i].bend;
    body.factors = candidates[i].factors;
    const std::optional<double> deviation = look.deviationOf(body, job);
    if (!deviation || (least && *deviation >= *least)) continue;
    least = deviation;
    outcome.best = i;
  }
  if (!least) return std::nullopt;
  outcome.motion = {look.scene(), *untouched, *least, look.noiseFloor(job).value_or(0),
                    *least <= *untouched ? KeptParameters::Tuned : KeptParameters::Untouched};
  return outcome;
}

}  // namespace limber
