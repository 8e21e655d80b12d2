#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/job.h"
#include "compare/motion_deviation.h"
#include "mesh/triangle_mesh.h"
#include "simulate/scenario.h"

namespace limber {

struct MotionOptions {
  SimulationOptions simulation;
  Scenario scenario;
  std::vector<uint32_t> pinned;            // vertices of the original
  std::vector<SurfacePoint> binding = {};  // of the vertices of the original, see carry_pins.h
  double calibration = 1;                  // Young's modulus of `other` over that of the original
  // What `other` is simulated with where the original has a solver; none: the same without its factors and
  // masses.
  std::optional<SimulatedSolver> otherSolver = {};
  bool doublesSubsteps = false;  // double the substeps until the original has converged, see compareMotion
  uint32_t sampleCount = kMotionSamples;  // points that the deviation is measured at
  bool records = false;                   // keep the positions after every step
};

// What the run of one body has cost and, where asked for, how the body has moved.
struct MotionRun {
  uint32_t constraints = 0, edges = 0;
  double secondsPerStep = 0;     // the shortest step, all work included
  std::vector<float> positions;  // [(step vertexCount + v) 3 + c] after each step, units of the mesh
};

// How differently two bodies move in the same scenario, in % of the diagonal. The noise floor is the mean
// deviation of the original from itself with its constraints in another order.
struct MotionComparison {
  MotionRun original;
  std::optional<MotionRun> other;
  MotionDeviation deviation;  // over points and steps
  double noiseFloor = 0;
  int substeps = 0;  // as used
  // The mean deviation of the original from itself with twice the substeps (but no more than a step can have,
  // which count as converged); not measured without `other`.
  double substepDeviation = 0;
  // Whether that is at most kConverged of the deviation of `other`, which then is not one of substeps.
  bool isConverged = false;
};

// By convention, see docs/report.md: substeps then change the deviation by at most a quarter of it.
inline constexpr double kConverged = 0.25;
// The most constraints that are solved in one run to see whether the original has converged (a run solves all
// constraints in every substep of every step); beyond it `doublesSubsteps` gives up. About a minute at 25 ns
// each.
inline constexpr double kMostSolved = 2e9;

// Runs the scenario with the original and, where it is given, with `other`: the same material except for the
// calibration or its own solver, and the pins carried over. The runs follow each other, so that each has its
// own time. The original runs once more with twice the substeps, to see whether it has converged; with
// `doublesSubsteps` the comparison is repeated with these until it has, or until kMostSolved. Throws as
// RunningScenario does, std::invalid_argument where `other` has no triangle, and std::runtime_error with a
// sentence as soon as a body has diverged.
MotionComparison compareMotion(const TriangleMesh& original, const TriangleMesh* other,
                               const MotionOptions& options, Job& job);

}  // namespace limber
