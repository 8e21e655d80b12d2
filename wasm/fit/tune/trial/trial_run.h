#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "fit/tune/trial/trial_scenes.h"
#include "mesh/surface_point.h"

namespace limber {

// The run of one body through a scene of MotionTrial.
struct TrialRun {
  const TrialScene& scene;
  const MovingBody& body;
  Pins pins = {};                           // of the body in this scene
  std::vector<SurfacePoint> samples = {};   // points of the body that are tracked
  uint32_t stride = 1;                      // every step is as long as this many steps of the scene
  uint32_t recordEvery = 1;                 // steps of the scene between records, divisible by `stride`
  std::function<void(double)> report = {};  // called with the completed fraction

  // The initial velocities in m/s.
  std::vector<Vec3> startVelocities() const {
    std::vector<Vec3> velocities;
    for (const Vec3& p : body.mesh.positions)
      velocities.push_back(scene.speed * initialVelocity(scene.scenario, p));
    return velocities;
  }
};

// Displacements of the samples in metres, [record sampleCount + sample]; nothing if the body cannot be moved.
using TrialDisplacements = std::optional<std::vector<Vec3>>;

}  // namespace limber
