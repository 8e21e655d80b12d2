#include "fit/tune/trial/trial_shell.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "mesh/vertex_areas.h"
#include "simulate/simulation.h"

namespace limber {
namespace {

// From mu h = E h / (2 (1 + nu)) and D = E h^3 / (12 (1 - nu^2)).
ElasticMaterial materialOf(const MovingBody& body) {
  const SolverConstants& constants = body.constants;
  if (!body.factors.empty() || !(constants.bend > 0))
    throw std::invalid_argument(
        "A shell of Morley's element moves with one thickness above 0 and one Young's modulus.");
  const double nu = constants.poisson, stretch = 2 * (1 + nu) * constants.stretch;
  const double thickness = std::sqrt(12 * (1 - nu * nu) * constants.bend / stretch);
  double surfaceDensity = constants.surfaceDensity;
  if (!body.masses.empty()) {
    const std::vector<double> areas = vertexAreas(body.mesh);
    surfaceDensity = std::accumulate(body.masses.begin(), body.masses.end(), 0.0) /
                     (std::accumulate(areas.begin(), areas.end(), 0.0) * constants.unit * constants.unit);
  }
  return {.young = stretch / thickness,
          .poisson = nu,
          .density = surfaceDensity / thickness,
          .thickness = thickness / constants.unit,
          .unit = constants.unit};
}

}  // namespace

TrialDisplacements moveShell(const TrialRun& run, Job& job) {
  const auto& [scene, body, pins, samples, stride, recordEvery, report] = run;
  const double timeScale = scene.step / Simulation::kStep;
  SimulationOptions options{.material = materialOf(body),
                            .substeps = kShellSubsteps / static_cast<int>(stride),
                            .keepsVolume = false};
  options.material.young *= timeScale * timeScale;
  Simulation simulation(body.mesh, options, pins);
  simulation.setGravity(scene.gravity * (timeScale * timeScale));
  std::vector<Vec3> velocities = run.startVelocities();
  for (Vec3& velocity : velocities) velocity *= timeScale;
  simulation.setVelocities(velocities);
  std::vector<Vec3> rest, displacements;
  for (const SurfacePoint& sample : samples) rest.push_back(simulation.position(sample));
  for (uint32_t step = 1; step <= scene.stepCount; ++step) {
    simulation.step(job);
    if (simulation.hasDiverged()) return std::nullopt;
    report(static_cast<double>(step) / scene.stepCount);
    if (step % recordEvery != 0) continue;
    for (size_t i = 0; i < rest.size(); ++i)
      displacements.push_back((simulation.position(samples[i]) - rest[i]) * body.constants.unit);
  }
  return displacements;
}

}  // namespace limber
