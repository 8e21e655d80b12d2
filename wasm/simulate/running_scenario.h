#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simulate/scenario.h"
#include "simulate/simulation.h"

namespace limber {

// One body on its way through a scenario: a Simulation with the clock, pins and loads of the scenario.
class RunningScenario {
 public:
  // Throws std::invalid_argument as Simulation does.
  RunningScenario(const TriangleMesh& mesh, const SimulationOptions& options, const Scenario& scenario,
                  const Pins& pins);

  // Advances by one step of 1/60 s. Throws Cancelled, after which the body must not be used any more. A step
  // never throws because the body has diverged: ask `requireNotDiverged`.
  void step(const Job& job, Helpers* helpers = nullptr);
  // Throws std::runtime_error with a sentence where Simulation::hasDiverged.
  void requireNotDiverged() const;
  // Seconds from the start.
  double time() const { return static_cast<double>(stepsDone_) * Simulation::kStep; }
  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  // Where the pins are now, in units of the mesh: pinned vertices first, then pinned points.
  std::vector<Vec3> pinPositions() const;
  // Seconds that the last step took on its own thread plus those that other threads worked on it; 0 before
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

// Advances every body by one step, each on a thread of its own; threads that have no body, or are done with
// theirs, help the others. Throws Cancelled.
void stepTogether(std::span<RunningScenario* const> bodies, const Job& job);

}  // namespace limber
