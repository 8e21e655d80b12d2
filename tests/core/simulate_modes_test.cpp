// The running material against the modal analysis: a body that starts in a mode swings with its frequency.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "modes/modes.h"
#include "shapes.h"
#include "simulate/simulation.h"

namespace limber {
namespace {

constexpr double kYoung = 1e6, kPoisson = 0.3, kDensity = 1000;

// A plate whose cells are cut along either diagonal, at random, with its inner vertices moved in the plane.
TriangleMesh irregularPlate(int cells) {
  TriangleMesh plate = shapes::grid(cells, cells);
  std::mt19937 random(3);
  for (size_t t = 0; t < plate.triangles.size(); t += 2) {
    if (random() % 2) continue;
    const Triangle a = plate.triangles[t], b = plate.triangles[t + 1];
    plate.triangles[t] = {a[0], a[1], b[2]};
    plate.triangles[t + 1] = {a[1], a[2], b[2]};
  }
  const TriangleMesh moved = shapes::jittered(plate, 0.25 / cells, 7);
  for (uint32_t v = 0; v < plate.vertexCount(); ++v) {
    Vec3& p = plate.positions[v];
    if (p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1) p = {moved.positions[v].x, moved.positions[v].y, 0};
  }
  return plate;
}

// Small near one corner.
TriangleMesh gradedPlate(int cells) {
  TriangleMesh plate = shapes::grid(cells, cells);
  for (Vec3& p : plate.positions) p = {p.x * (0.3 + 0.7 * p.x), p.y * (0.3 + 0.7 * p.y), 0};
  return plate;
}

// Diagonals in turn, as the flag has them: the mesh that half folds alone get wrong by 44 %.
TriangleMesh unionJack(int cells) {
  TriangleMesh plate = shapes::grid(cells, cells);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      if ((i + j) % 2) continue;
      const size_t t = 2 * static_cast<size_t>(j * cells + i);
      const Triangle a = plate.triangles[t], b = plate.triangles[t + 1];
      plate.triangles[t] = {a[0], a[1], b[2]};
      plate.triangles[t + 1] = {a[1], a[2], b[2]};
    }
  return plate;
}

struct Swing {
  double frequencyError;  // relative
  double inPlane;         // share of the shape that lies in the plate, 0..1
};

// Starts the body in each mode at a small amplitude, and times the zero crossings of what it still shares
// with the mode. A hundred steps a period, and substeps so that a period has `perPeriod` of them.
std::vector<Swing> swingModes(const TriangleMesh& mesh, double thickness, int modeCount, int perPeriod,
                              double timeScale) {
  Job job;
  const ModeSet set =
      computeModes(mesh, {Model::Shell, modeCount, thickness, kYoung, kPoisson, kDensity, 1}, job);
  std::vector<Swing> swings;
  for (int k = 0; k < modeCount; ++k) {
    // The clock is the simulation's own step of 1/60 s, so the material is made slow or fast to fit: the
    // square of a frequency goes with Young's modulus.
    const double period = 2 * std::numbers::pi / set.modes[k].omega, wished = timeScale;
    const double stretch = period / wished;
    SimulationOptions options;
    options.young = kYoung * stretch * stretch;
    options.poisson = kPoisson;
    options.density = kDensity;
    options.thickness = thickness;
    const int steps = static_cast<int>(std::lround(wished / Simulation::kStep));
    options.substeps = perPeriod / steps;
    Simulation body(mesh, options);
    const float* shape = set.shapes.data() + size_t(k) * 3 * mesh.vertexCount();
    const auto along = [&](uint32_t v) { return Vec3{shape[3 * v], shape[3 * v + 1], shape[3 * v + 2]}; };
    // Struck, not bent: so the edges' turns find their part of the shape on the way.
    const double speed = 1e-3 * bounds(mesh).diagonal() * 2 * std::numbers::pi / wished;
    std::vector<Vec3> start(mesh.vertexCount());
    double flat = 0, all = 0;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      start[v] = along(v) * speed;
      all += squaredLength(along(v));
      flat += along(v).x * along(v).x + along(v).y * along(v).y;
    }
    body.setVelocities(start);
    std::vector<double> crossings;
    double before = 0;
    for (int i = 1; i <= 4 * steps && crossings.size() < 3; ++i) {
      body.step(job);
      double share = 0;
      for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
        share += dot(along(v), body.position(v) - mesh.positions[v]);
      if (share * before < 0) crossings.push_back(i - share / (share - before));
      before = share;
    }
    if (crossings.size() < 3) {
      ADD_FAILURE() << "mode " << k + 1 << " does not swing";
      continue;
    }
    const double found = (crossings[2] - crossings[0]) * Simulation::kStep;
    swings.push_back({wished / found - 1, flat / all});
  }
  return swings;
}

double worst(const std::vector<Swing>& swings) {
  double error = 0;
  for (const Swing& swing : swings) error = std::max(error, std::abs(swing.frequencyError));
  for (const Swing& swing : swings) printf("%6.2f/%.2f ", 100 * swing.frequencyError, swing.inPlane);
  printf("\n");
  return error;
}

TEST(SimulatedModes, aPlateBendsWithTheFrequenciesOfItsModesOnAnyMesh) {
  for (const TriangleMesh& plate : {shapes::grid(8, 8), unionJack(8), irregularPlate(8), gradedPlate(8)})
    EXPECT_LT(worst(swingModes(plate, 0.02, 6, 2000, 1)), 0.02);
}

TEST(SimulatedModes, aPlateStretchesWithTheFrequenciesOfItsModesOnAnyMesh) {
  for (const TriangleMesh& plate : {shapes::grid(6, 6), unionJack(6), irregularPlate(6), gradedPlate(6)})
    EXPECT_LT(worst(swingModes(plate, 2, 6, 2000, 1)), 0.02);
}

TEST(SimulatedModes, closedBodiesSwingWithTheFrequenciesOfTheirModes) {
  for (const TriangleMesh& body :
       {shapes::sphere(1), shapes::box(2, 2, 6, 0.5), shapes::jittered(shapes::torus(10, 6), 0.05, 2)})
    EXPECT_LT(worst(swingModes(body, 0.02 * bounds(body).diagonal(), 4, 4000, 1)), 0.05);
}

}  // namespace
}  // namespace limber
