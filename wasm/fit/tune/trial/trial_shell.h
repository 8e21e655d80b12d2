#pragma once

#include "base/job.h"
#include "fit/tune/trial/trial_run.h"

namespace limber {

// Moves a body of the shell with Morley's element by the XPBD of simulate/simulation.h: its thickness,
// Young's modulus and density are derived from the constants and the total mass of the body. Time is scaled
// so that a step of the scene is a step of the simulation, of kShellSubsteps / stride substeps. Returns
// nothing if the body diverges. Throws Cancelled, and std::invalid_argument if the body has factors per
// constraint, or no bending stiffness, from which the thickness follows.
inline constexpr int kShellSubsteps = 60;
TrialDisplacements moveShell(const TrialRun& run, Job& job);

}  // namespace limber
