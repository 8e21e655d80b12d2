// Simulations with any options: positions stay finite, or a sentence says that the body has diverged.

#include "draw_simulation.h"
#include "promises.h"
#include "simulate/running_scenario.h"
#include "soup.h"

namespace limber::fuzz {

void fuzzSimulate(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 60);
  const SimulationOptions options = drawSimulationOptions(input);
  const Scenario scenario = drawScenario(input, mesh, options.material.unit);
  Job job;
  RunningScenario body({mesh, options, {.vertices = defaultPins(mesh, scenario)}}, scenario, job);
  for (int step = 0; step < 12; ++step) {
    body.step(job);
    body.requireNotDiverged();
    for (const Vec3& p : body.simulation().positions())
      for (int c = 0; c < 3; ++c) require(std::isfinite(p[c]), "a body that has not diverged is finite");
  }
}

}  // namespace limber::fuzz
