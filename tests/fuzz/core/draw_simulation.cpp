#include "draw_simulation.h"

namespace limber::fuzz {
namespace {

double drawNumber(FuzzInput& input, double usual) {
  if (input.chance(24)) return static_cast<double>(input.anyFloat());
  return input.chance(64) ? usual * std::pow(10, input.real(-6, 6)) : usual;
}

}  // namespace

SimulationOptions drawSimulationOptions(FuzzInput& input) {
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

Scenario drawScenario(FuzzInput& input, const TriangleMesh& mesh, double unit) {
  const auto names = scenarioNames();
  Scenario scenario;
  scenario.kind = scenarioKind(names[input.byte() % names.size()]);
  scenario.box = bounds(mesh);
  scenario.seconds = 0.2;
  scenario.unit = unit;
  scenario.pose = startPose(scenario.kind, mesh);
  if (input.chance(64)) scenario.added.ground = static_cast<double>(input.anyFloat());
  if (input.chance(64)) {
    const Vec3 centre{input.real(-1, 1), input.real(-1, 1), input.real(-1, 1)};
    scenario.added.colliders.push_back({centre, centre, input.real(0.01, 1)});
  }
  return scenario;
}

}  // namespace limber::fuzz
