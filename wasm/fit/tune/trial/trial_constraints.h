#pragma once

#include "base/job.h"
#include "fit/tune/trial/trial_run.h"

namespace limber {

// Moves a body of springs, hinges and membranes by implicit steps. Returns nothing if they do not converge or
// take too long. Must be called within a WholePhase. Throws Cancelled.
TrialDisplacements moveConstraints(const TrialRun& run, const SolverModel& model, Job& job);

}  // namespace limber
