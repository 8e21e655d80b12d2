#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simulate/scenario.h"
#include "simulate/simulation.h"

namespace limber {

// A body at rest. Holds references.
struct BodyAtRest {
  const TriangleMesh& mesh;
  const SimulationOptions& options;
  const Pins& pins;
};

// The run of one body through a scenario: a Simulation with the clock, pins and loads of the scenario.
class RunningScenario {
 public:
  // Throws std::invalid_argument and Cancelled as Simulation does.
  RunningScenario(const BodyAtRest& body, const Scenario& scenario, Job& job);

  // Advances by one step of 1/60 s. Throws Cancelled, after which the body must not be used any more. A step
  // does not throw if the body has diverged: call `requireNotDiverged`.
  void step(const Job& job, Helpers* helpers = nullptr);
  // Throws std::runtime_error with a sentence if Simulation::hasDiverged.
  void requireNotDiverged() const;
  // Seconds from the start.
  double time() const { return static_cast<double>(stepsDone_) * Simulation::kStep; }
  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  // The current positions of the pins, in units of the mesh: pinned vertices first, then pinned points.
  std::vector<Vec3> pinPositions() const;
  // The seconds of the last step on its own thread plus those of other threads that worked on it; 0 before
  // the first step.
  double stepSeconds() const { return stepSeconds_; }

 private:
  Scenario scenario_;
  Simulation simulation_;
  Pins pins_;
  double stepSeconds_ = 0;
  std::vector<Vec3> pinRest_;
  uint64_t stepsDone_ = 0;
};

// Advances every body by one step, each on a thread of its own; threads without a body, or that have finished
// theirs, help the others. Throws Cancelled.
void stepTogether(std::span<RunningScenario* const> bodies, const Job& job);

}  // namespace limber
