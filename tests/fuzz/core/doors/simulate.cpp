// Simulations with any options: positions stay finite, or a sentence says that the body has diverged.

#include "compare/compare_motion.h"
#include "promises.h"
#include "simulate/running_scenario.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

double drawNumber(FuzzInput& input, double usual) {
  if (input.chance(24)) return static_cast<double>(input.anyFloat());
  return input.chance(64) ? usual * std::pow(10, input.real(-6, 6)) : usual;
}

SimulationOptions drawOptions(FuzzInput& input) {
  SimulationOptions options;
  options.material = {drawNumber(input, 1e6), input.chance(32) ? input.real(-2, 2) : 0.3,
                      drawNumber(input, 1000), drawNumber(input, 0.01), drawNumber(input, 1)};
  options.model = static_cast<SimulationModel>(input.byte() % 3);
  options.substeps = 1 + input.byte() % 4;
  options.damping = drawNumber(input, 0.5);
  options.friction = drawNumber(input, 0.5);
  options.keepsVolume = input.chance(128);
  options.selfCollision = input.chance(64);
  options.order = input.byte() % 3;
  return options;
}

}  // namespace

void enterSimulate(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 60);
  const SimulationOptions options = drawOptions(input);
  const auto names = scenarioNames();
  Scenario scenario;
  scenario.kind = scenarioKind(names[input.byte() % names.size()]);
  scenario.box = bounds(mesh);
  scenario.seconds = 0.2;
  scenario.unit = options.material.unit;
  scenario.pose = startPose(scenario.kind, mesh);
  if (input.chance(64)) scenario.added.ground = static_cast<double>(input.anyFloat());
  if (input.chance(64)) {
    const Vec3 centre{input.real(-1, 1), input.real(-1, 1), input.real(-1, 1)};
    scenario.added.colliders.push_back({centre, centre, input.real(0.01, 1)});
  }
  Job job;
  RunningScenario body(mesh, options, scenario, {.vertices = defaultPins(mesh, scenario)});
  for (int step = 0; step < 12; ++step) {
    body.step(job);
    body.requireNotDiverged();
    for (const Vec3& p : body.simulation().positions())
      for (int c = 0; c < 3; ++c) require(std::isfinite(p[c]), "a body that has not diverged is finite");
  }
}

}  // namespace limber::fuzz
