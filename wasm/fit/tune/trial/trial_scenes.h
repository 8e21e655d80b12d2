#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/job.h"
#include "fit/tune/moving_body.h"
#include "simulate/scenario.h"

namespace limber {

// A scene of MotionTrial. It is derived from the original and the same for all bodies.
struct TrialScene {
  std::string name;        // 'sway' or 'hang'
  Scenario scenario;       // used for its initial velocity
  double speed = 0;        // factor on the initial velocity of the scenario
  Vec3 gravity = {};       // m/s2
  bool usersPins = false;  // whether bodies are pinned by the user's pins
  Pins pins = {};          // of the original
  double step = 0;         // seconds
  uint32_t stepCount = 0;  // divisible by 4
  double motionSize = 0;   // metres
};

// The scenes of an original, with durations from its own vibrations. A scene in which nothing swings, or in
// which everything is pinned, is skipped. Must be called within a WholePhase. Throws Cancelled.
std::vector<TrialScene> trialScenes(const MovingBody& original, const SolverModel& model, Job& job);

// Whether a surface has so little border that it moves like a closed one: less than half its diagonal.
bool isNearlyClosed(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
