#include "fit/part_limits.h"

#include <algorithm>

#include "mesh/quality.h"

namespace limber {

PartLimits::PartLimits(const FitPart& part, const ClosestPointTree& treeOfOriginal, const Asked& asked) {
  steps.partners = part.partners();
  if (asked.minAngle > 0) steps.minAngle = std::min(asked.minAngle, measureQuality(part.result).minAngle);
  if (asked.maxDeviation > 0)
    steps.deviation = &deviation.emplace(part.original, treeOfOriginal,
                                         asked.maxDeviation / part.frame.diagonal, asked.samples);
}

}  // namespace limber
