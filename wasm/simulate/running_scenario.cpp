#include "simulate/running_scenario.h"

#include <chrono>
#include <stdexcept>

#include "base/parallel.h"
#include "simulate/schedule.h"

namespace limber {

namespace {

SimulationOptions optionsIn(const Scenario& scenario, const TriangleMesh& mesh, SimulationOptions options) {
  options.selfCollision = options.selfCollision || touchesItself(scenario, mesh);
  return options;
}

}  // namespace

RunningScenario::RunningScenario(const BodyAtRest& body, const Scenario& scenario, Job& job)
    : scenario_(scenario),
      simulation_(posed(scenario, body.mesh), optionsIn(scenario, body.mesh, body.options), body.pins, job),
      pins_(body.pins) {
  for (const uint32_t v : pins_.vertices) pinRest_.push_back(posed(scenario, body.mesh.positions[v]));
  for (const SurfacePoint& point : pins_.points) pinRest_.push_back(simulation_.position(point));
  startScenario(scenario_, body.mesh.positions, simulation_);
}

void RunningScenario::step(const Job& job, Helpers* helpers) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  prepareStep(scenario_, time(), pinRest_, simulation_);
  simulation_.step(job, helpers);
  stepSeconds_ = std::chrono::duration<double>(Clock::now() - start).count() + simulation_.helpedSeconds();
  ++stepsDone_;
}

void RunningScenario::requireNotDiverged() const {
  if (simulation_.hasDiverged())
    throw std::runtime_error("The simulation has flown apart: give it more substeps or a softer material.");
}

std::vector<Vec3> RunningScenario::pinPositions() const {
  std::vector<Vec3> positions;
  for (const uint32_t v : pins_.vertices) positions.push_back(simulation_.position(v));
  for (const SurfacePoint& point : pins_.points) positions.push_back(simulation_.position(point));
  return positions;
}

void stepTogether(std::span<RunningScenario* const> bodies, const Job& job) {
  if (bodies.size() == 1) return bodies[0]->step(job);
  Helpers helpers(bodies.size());
  const auto stepOne = [&](RunningScenario& body) {
    try {
      body.step(job, &helpers);
    } catch (...) {
      helpers.endTask();
      throw;
    }
    helpers.endTask();
  };
  // A thread that finds no more bodies helps with the bodies of other threads.
  const size_t helpCount = static_cast<size_t>(threadCount()) - 1;
  parallelFor(bodies.size() + helpCount, 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) i < bodies.size() ? stepOne(*bodies[i]) : helpers.help();
  });
}

}  // namespace limber
