#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "fit/fit_part.h"
#include "fit/search/guarded_step.h"
#include "fit/surface/fit_samples.h"

namespace limber {

struct SurfaceRoundsInput {
  const FitSamples& samples;  // of part.original
  const StepLimits& limits;
  // In units of the file; flips may displace the surface by a fraction of it. 0: no limit.
  double maxDeviation = 0;
};

// Improves part.result before the search for modes: rounds that flip edges to Delaunay and fit the vertices
// to the surface of the original. `corners` (3 t + c) are permuted with the corners of flipped triangles.
// Returns the number of flips. Throws Cancelled.
uint32_t runSurfaceRounds(FitPart& part, const SurfaceRoundsInput& input, std::vector<uint32_t>& corners,
                          Job& job);

}  // namespace limber
