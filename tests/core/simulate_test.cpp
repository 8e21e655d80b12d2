#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/parallel.h"
#include "moving_bodies.h"
#include "shapes.h"

namespace limber {
namespace {

using moving_bodies::kGravity;
using moving_bodies::rubber;
using moving_bodies::run;

TEST(Simulation, aFallingBodyFollowsTheParabolaUnderFewAndManySubsteps) {
  const TriangleMesh mesh = shapes::sphere(1, 0.3);
  for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell})
    for (const int substeps : {20, 2000}) {
      Simulation body(mesh, rubber(0.01, substeps, model));
      body.setGravity(kGravity);
      const Vec3 thrown = {2, 3, -1};
      body.setVelocities(std::vector<Vec3>(mesh.positions.size(), thrown));
      run(body, 60);
      // Symplectic Euler falls by g t (t + dt) / 2.
      const double t = 1, dt = Simulation::kStep / substeps;
      for (uint32_t v = 0; v < body.vertexCount(); ++v) {
        const Vec3 expected = mesh.positions[v] + thrown * t + kGravity * (t * (t + dt) / 2);
        EXPECT_LT(length(body.position(v) - expected), 1e-4);
        EXPECT_LT(length(body.velocity(v) - (thrown + kGravity * t)), 5e-3);
      }
    }
}

TEST(Simulation, aBodyAtRestStaysExactlyWhereItIs) {
  const TriangleMesh mesh = shapes::torus(12, 8);
  for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell}) {
    Simulation body(mesh, rubber(0.05, 20, model));
    run(body, 10);
    for (uint32_t v = 0; v < body.vertexCount(); ++v)
      EXPECT_LT(length(body.position(v) - mesh.positions[v]), 1e-6);
    // Rounding of float lengths, squared, times Young's modulus and volume.
    EXPECT_LT(body.elasticEnergy(), 1e-13 * 1e6 * body.mass() / 1000);
  }
}

}  // namespace
}  // namespace limber
