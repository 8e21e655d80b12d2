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
  std::vector<SurfacePoint> binding = {};  // per vertex of the original, see carry_pins.h
  double calibration = 1;                  // Young's modulus of `other` over that of the original
  // The solver of `other` if the original has one; none: the original's solver without its factors and
  // masses.
  std::optional<SimulatedSolver> otherSolver = {};
  bool doublesSubsteps = false;  // double the substeps until the original has converged, see compareMotion
  uint32_t sampleCount = kMotionSamples;  // points at which the deviation is measured
  bool records = false;                   // keep the positions after every step
};

// The time that the run of one body took and, if requested, its motion.
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
  // The mean deviation of the original from itself with twice the substeps; not measured without `other`. The
  // number of substeps is capped at the largest that a step can have, which counts as converged.
  double substepDeviation = 0;
  // Whether that is at most kConverged times the deviation of `other`, so that the latter is not due to the
  // substeps.
  bool isConverged = false;
};

// By convention, see docs/report.md: substeps then change the deviation by at most a quarter of it.
inline constexpr double kConverged = 0.25;
// The most constraint solves in one run that checks whether the original has converged (a run solves all
// constraints in every substep of every step); beyond it `doublesSubsteps` gives up. About a minute at 25 ns
// each.
inline constexpr double kMaxSolved = 2e9;

// Runs the scenario with the original and, if given, with `other`, which has the same material except for the
// calibration or its own solver, and the pins carried over. The bodies run one after the other, so that each
// is timed separately. The original runs once more with twice the substeps, to see whether it has converged;
// with `doublesSubsteps` the comparison is repeated with the doubled number until it has, or until
// kMaxSolved is reached. Throws as RunningScenario does, std::invalid_argument if `other` has no triangle,
// and std::runtime_error with a sentence as soon as a body has diverged.
MotionComparison compareMotion(const TriangleMesh& original, const TriangleMesh* other,
                               const MotionOptions& options, Job& job);

}  // namespace limber
