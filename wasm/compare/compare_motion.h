#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simulate/scenario.h"

namespace limber {

struct MotionOptions {
  SimulationOptions simulation;
  Scenario scenario;
  std::vector<uint32_t> pinned;             // vertices of the original
  std::vector<SurfacePoint> binding = {};  // of the original's vertices to `other`, see carry_pins.h
  double calibration = 1;                   // Young's modulus of `other` over the original's
  uint32_t sampleCount = 1000;              // points that are followed
  bool records = false;                     // keep the positions of every step
};

// What one body has cost, and, where asked for, how it has moved.
struct MotionRun {
  uint32_t constraints = 0, edges = 0;
  double secondsPerStep = 0;     // the shortest step, all work included
  std::vector<float> positions;  // positions[(step * vertexCount + v) * 3 + c] after each step, in mesh units
};

// How far two bodies in the same scenario move apart, in % of the original's diagonal: points spread evenly
// by area over the original, bound at rest to the closest point of the other; of each the difference between
// the two displacements. `noiseFloor`: the mean for the original against itself with its constraints in
// another order.
struct MotionComparison {
  MotionRun original;
  std::optional<MotionRun> other;
  double deviationMean = 0, deviationMax = 0;  // over points and steps
  double noiseFloor = 0;
};

// Runs the scenario with the original and, where it is given, with `other` (the same material but for the
// calibration, and the pins carried over), each on its own so that its time is its own. Throws as
// RunningScenario.
MotionComparison compareMotion(const TriangleMesh& original, const TriangleMesh* other,
                               const MotionOptions& options, Job& job);

}  // namespace limber
