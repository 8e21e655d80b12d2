#pragma once

#include <optional>

#include "fit/fit_part.h"
#include "fit/search/deviation_guard.h"
#include "fit/search/guarded_step.h"

namespace limber {

// The limits that the steps of a part respect, and the guard that enforces one of them.
struct PartLimits {
  std::optional<DeviationGuard> deviation;
  StepLimits steps;  // refers to `deviation`

  struct Asked {
    double maxDeviation = 0;           // in units of the file; 0: no limit
    double minAngle = 0;               // degrees; 0: no limit
    uint32_t samples = kGuardSamples;  // of each surface, at which the deviation is measured
  };
  // Keeps references to `part` and to the tree over its original. If the part violates the limit on angles,
  // the limit becomes its smallest angle.
  PartLimits(const FitPart& part, const ClosestPointTree& treeOfOriginal, const Asked& asked);
  PartLimits(const PartLimits&) = delete;
};

}  // namespace limber
