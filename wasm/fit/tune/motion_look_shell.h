#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fit/tune/motion_look_run.h"

namespace limber {

// runScene for the shell with Morley's element, by the XPBD of simulate/simulation.h: its thickness, Young's
// modulus and density are those that amount to the constants and the total mass of the body. Time is scaled
// so that a step of the scene is a step of the simulation, of kShellSubsteps / stride substeps. Nothing where
// the body diverges. Throws std::invalid_argument where the body has factors per constraint, or no bending
// stiffness, which needs a thickness.
inline constexpr int kShellSubsteps = 60;
std::optional<std::vector<Vec3>> runShellScene(const LookScene& scene, const MovingBody& body,
                                               const LookRun& run, const std::function<void(double)>& report,
                                               Job& job);

}  // namespace limber
