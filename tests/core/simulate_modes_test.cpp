// The simulated material compared with the modal analysis: a body that is struck in a mode vibrates with its
// frequency.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "elastic/modes.h"
#include "moving_bodies.h"
#include "shapes.h"

namespace limber {
namespace {

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

// A plate whose cells are small near one corner.
TriangleMesh gradedPlate(int cells) {
  TriangleMesh plate = shapes::grid(cells, cells);
  for (Vec3& p : plate.positions) p = {p.x * (0.3 + 0.7 * p.x), p.y * (0.3 + 0.7 * p.y), 0};
  return plate;
}

// Diagonals alternate, as in the union jack: with just half folds the frequencies of this mesh are off by 44
// %.
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

double inPlaneShare(const float* shape, uint32_t vertexCount) {
  double inPlane = 0, all = 0;
  for (uint32_t v = 0; v < vertexCount; ++v) {
    const double x = shape[3 * v], y = shape[3 * v + 1], z = shape[3 * v + 2];
    inPlane += x * x + y * y;
    all += x * x + y * y + z * z;
  }
  return inPlane / all;
}

// Of the lowest modes, with periods of `substeps` substeps.
std::vector<Swing> swingModes(const TriangleMesh& mesh, double thickness, int modeCount, int substeps) {
  SimulationOptions options = moving_bodies::rubber(thickness, substeps / 60);
  options.keepsVolume = false;  // the analysis has no volume constraint
  Job job;
  const ModeSet set = computeModes(mesh, {ElasticModel::Shell, modeCount, options.material}, job);
  std::vector<Swing> swings;
  for (int k = 0; k < modeCount; ++k) {
    const float* const shape = set.shapes.data() + size_t(k) * 3 * mesh.vertexCount();
    swings.push_back({moving_bodies::frequencyError(mesh, set.modes[k], shape, options),
                      inPlaneShare(shape, mesh.vertexCount())});
  }
  return swings;
}

double worst(const std::vector<Swing>& swings) {
  double error = 0;
  for (const Swing& swing : swings) error = std::max(error, std::abs(swing.frequencyError));
  return error;
}

TEST(SimulatedModes, aPlateBendsWithTheFrequenciesOfItsModesOnAnyMesh) {
  for (const TriangleMesh& plate : {shapes::grid(8, 8), unionJack(8), irregularPlate(8), gradedPlate(8)})
    EXPECT_LT(worst(swingModes(plate, 0.02, 6, 2000)), 0.02);
}

TEST(SimulatedModes, aPlateStretchesWithTheFrequenciesOfItsModesOnAnyMesh) {
  for (const TriangleMesh& plate : {shapes::grid(6, 6), unionJack(6), irregularPlate(6), gradedPlate(6)})
    for (const Swing& swing : swingModes(plate, 2, 6, 1000)) {
      EXPECT_GT(swing.inPlane, 0.99);
      EXPECT_LT(std::abs(swing.frequencyError), 0.01);
    }
}

TEST(SimulatedModes, closedBodiesSwingWithTheFrequenciesOfTheirModes) {
  for (const TriangleMesh& body :
       {shapes::sphere(1), shapes::box(2, 2, 6, 0.5), shapes::jittered(shapes::torus(10, 6), 0.05, 2)})
    EXPECT_LT(worst(swingModes(body, 0.02 * bounds(body).diagonal(), 4, 4000)), 0.05);
}

}  // namespace
}  // namespace limber
