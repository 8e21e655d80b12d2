#pragma once

#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simulate/scenario.h"
#include "simulate/simulation.h"

namespace limber {

// A body on its way through a scenario.
class RunningScenario {
 public:
  // Throws std::invalid_argument as Simulation does.
  RunningScenario(const TriangleMesh& mesh, const SimulationOptions& options, const Scenario& scenario,
                  const Pins& pins);

  // Throws Cancelled, after which it is of no use, and std::runtime_error with a sentence where the body has
  // flown apart.
  void step(const Job& job, Helpers* helpers = nullptr);
  // Seconds from the start.
  double time() const { return static_cast<double>(stepsDone_) * Simulation::kStep; }
  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  // Where the pins are, in units of the mesh: vertices, then points.
  std::vector<Vec3> pinPositions() const;
  // Seconds that the last step took on its thread, and those that others have helped with; 0 before the
  // first.
  double stepSeconds() const { return stepSeconds_; }

 private:
  Scenario scenario_;
  Simulation simulation_;
  Pins pins_;
  double stepSeconds_ = 0;
  std::vector<Vec3> pinRest_;
  uint64_t stepsDone_ = 0;
};

// One step of each, on as many threads as there are bodies; threads that are left over, or done, help.
void stepTogether(std::span<RunningScenario* const> bodies, const Job& job);

}  // namespace limber
