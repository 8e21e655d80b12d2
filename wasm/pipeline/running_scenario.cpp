#include "pipeline/running_scenario.h"

#include <chrono>
#include <stdexcept>

#include "base/parallel.h"

namespace limber {

RunningScenario::RunningScenario(const TriangleMesh& mesh, const SimulationOptions& options,
                                 const Scenario& scenario, const Pins& pins)
    : scenario_(scenario), simulation_(mesh, options, pins), pins_(pins) {
  for (const uint32_t v : pins.vertices) pinRest_.push_back(mesh.positions[v]);
  for (const SurfaceAnchor& point : pins.points) pinRest_.push_back(simulation_.position(point));
  startScenario(scenario_, mesh.positions, simulation_);
}

void RunningScenario::step(const Job& job) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  prepareStep(scenario_, time(), pinRest_, simulation_);
  simulation_.step(job);
  stepSeconds_ = std::chrono::duration<double>(Clock::now() - start).count();
  ++stepsDone_;
  if (!simulation_.isFinite())
    throw std::runtime_error("The simulation has flown apart: give it more substeps or a softer material.");
}

std::vector<Vec3> RunningScenario::pinPositions() const {
  std::vector<Vec3> places;
  for (const uint32_t v : pins_.vertices) places.push_back(simulation_.position(v));
  for (const SurfaceAnchor& point : pins_.points) places.push_back(simulation_.position(point));
  return places;
}

void stepTogether(std::span<RunningScenario* const> bodies, const Job& job) {
  parallelFor(bodies.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) bodies[i]->step(job);
  });
}

}  // namespace limber
