#include "pipeline/running_scenario.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "base/parallel.h"
#include "measure/closest_point.h"

namespace limber {

namespace {

// A barycentric coordinate this close to 1 is a vertex.
constexpr double kAtVertex = 1 - 1e-6;

bool comesBefore(const SurfaceAnchor& a, const SurfaceAnchor& b) {
  return a.triangle != b.triangle ? a.triangle < b.triangle
                                  : std::lexicographical_compare(a.barycentric, a.barycentric + 3,
                                                                 b.barycentric, b.barycentric + 3);
}

}  // namespace

Pins carryPins(const TriangleMesh& original, std::span<const uint32_t> pinned, const TriangleMesh& other,
               std::span<const SurfaceAnchor> binding) {
  Pins pins;
  const ClosestPointTree tree(other);
  const auto placeOf = [&](uint32_t v) {
    if (!binding.empty()) return binding[v];
    const SurfacePoint point = tree.closest(original.positions[v]);
    return SurfaceAnchor{point.triangle, {point.barycentric[0], point.barycentric[1], point.barycentric[2]}};
  };
  for (const uint32_t v : pinned) {
    const SurfaceAnchor point = placeOf(v);
    if (point.triangle == kNone) continue;
    const double* const share = std::max_element(point.barycentric, point.barycentric + 3);
    if (*share > kAtVertex)
      pins.vertices.push_back(other.triangles[point.triangle][share - point.barycentric]);
    else
      pins.points.push_back(point);
  }
  std::sort(pins.vertices.begin(), pins.vertices.end());
  pins.vertices.erase(std::unique(pins.vertices.begin(), pins.vertices.end()), pins.vertices.end());
  std::sort(pins.points.begin(), pins.points.end(), comesBefore);
  return pins;
}

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
