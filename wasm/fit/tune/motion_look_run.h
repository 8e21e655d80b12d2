#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/job.h"
#include "fit/tune/motion_look_scenes.h"
#include "mesh/surface_point.h"

namespace limber {

// Sample points of an original on a body of a look: see compare/motion_deviation.h.
std::vector<SurfacePoint> lookSamples(const TriangleMesh& original, const TriangleMesh& body);

struct LookRun {
  std::vector<SurfacePoint> samples;  // of the body
  Pins pins;                          // of the body in this scene
  uint32_t stride = 1;                // each step is as long as so many of the scene's, which they divide
  uint32_t recordEvery = 1;           // steps of the scene between records, divisible by `stride`
};

// Displacements of the samples while the body goes through the scene: [record sampleCount + sample], metres.
// Nothing if the solver of time steps fails. `report` is called with the fraction that is done. To be called
// within a WholePhase. Throws Cancelled.
std::optional<std::vector<Vec3>> runScene(const LookScene& scene, const MovingBody& body,
                                          const SolverModel& model, const LookRun& run,
                                          const std::function<void(double)>& report, Job& job);

}  // namespace limber
