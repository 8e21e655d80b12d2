#pragma once

#include <optional>

#include "fit/fit_part.h"
#include "fit/search/deviation_guard.h"
#include "fit/search/guarded_step.h"

namespace limber {

// The limits that the steps of a part keep, and the guard of the deviation.
struct PartLimits {
  std::optional<DeviationGuard> deviation;
  StepLimits steps;  // refers to `deviation`

  struct Asked {
    double maxDeviation = 0;           // in units of the file; 0: no limit
    double minAngle = 0;               // degrees; 0: no limit
    uint32_t samples = kGuardSamples;  // of each surface, at which the deviation is judged
  };
  // Keeps references to `part` and to the tree over its original. A limit on angles that the part violates
  // becomes its smallest angle.
  PartLimits(const FitPart& part, const ClosestPointTree& treeOfOriginal, const Asked& asked);
  PartLimits(const PartLimits&) = delete;
};

}  // namespace limber
