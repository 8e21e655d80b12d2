#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "elastic/modes.h"
#include "shapes.h"

namespace limber {
namespace {

ModesOptions unitShell(double thickness, int modeCount = 8) {
  return {ElasticModel::Shell, modeCount, unitMaterial(thickness)};
}

// omega a^2 sqrt(rho h / D) of a free square plate, nu = 0.3 (Leissa 1969).
const std::vector<double> kPlate = {13.468, 19.596, 24.270, 34.801, 34.801, 61.093};

std::vector<double> plateErrors(const TriangleMesh& plate) {
  const double h = 0.01, rigidity = h * h * h / (12 * (1 - 0.09));
  Job job;
  const ModeSet set = computeModes(plate, unitShell(h, 6), job);
  EXPECT_EQ(set.components[0].zeroModesFound, 6u);
  std::vector<double> errors;
  for (size_t k = 0; k < kPlate.size(); ++k) {
    EXPECT_LE(set.modes[k].residual, 1e-7);
    errors.push_back(set.modes[k].omega * std::sqrt(h / rigidity) / kPlate[k] - 1);
  }
  return errors;
}

// Moves the inner vertices within the plane.
TriangleMesh irregularPlate(int cells) {
  TriangleMesh plate = shapes::grid(cells, cells);
  const TriangleMesh moved = shapes::jittered(plate, 0.2 / cells, 7);
  for (uint32_t v = 0; v < plate.vertexCount(); ++v) {
    Vec3& p = plate.positions[v];
    if (p.x > 0 && p.x < 1) p.x = moved.positions[v].x;
    if (p.y > 0 && p.y < 1) p.y = moved.positions[v].y;
  }
  return plate;
}

TEST(ShellModes, aFreeSquarePlateVibratesAsInLeissasTable) {
  for (const TriangleMesh& plate : {shapes::grid(64, 64), irregularPlate(64)})
    for (double error : plateErrors(plate)) EXPECT_LT(std::abs(error), 0.01);
}

TEST(ShellModes, thePlatesErrorShrinksAtSecondOrder) {
  const auto coarse = plateErrors(shapes::grid(8, 8)), fine = plateErrors(shapes::grid(16, 16)),
             finest = plateErrors(shapes::grid(32, 32));
  // Richardson: the table only has five digits, so the limit is extrapolated from the sequence itself.
  for (size_t k = 0; k < kPlate.size(); ++k) {
    const double order = std::log2((fine[k] - coarse[k]) / (finest[k] - fine[k]));
    EXPECT_GT(order, 1.7) << "mode " << k + 1;
  }
}

TEST(ShellModes, everyFreeBodyHasSixZeroModesAndSmallResiduals) {
  for (const TriangleMesh& mesh : {shapes::grid(20, 20), shapes::box(8, 8, 24, 0.125), shapes::sphere(2),
                                   shapes::torus(24, 12), shapes::jittered(shapes::sphere(2), 0.02, 3),
                                   shapes::jittered(shapes::box(8, 8, 24, 0.125), 0.02, 4)}) {
    Job job;
    const ModeSet set = computeModes(mesh, unitShell(0.02 * bounds(mesh).diagonal(), 12), job);
    EXPECT_EQ(set.components[0].zeroModesExpected, 6u);
    EXPECT_EQ(set.components[0].zeroModesFound, 6u);
    ASSERT_EQ(set.modes.size(), 12u);
    for (const Mode& mode : set.modes) {
      EXPECT_LE(mode.residual, 1e-7);
      EXPECT_GT(mode.omega, 0);
    }
  }
}

TEST(ShellModes, aSpheresModesComeInWholeClusters) {
  Job job;
  const ModeSet set = computeModes(shapes::sphere(3), unitShell(0.04, 12), job);
  // l = 2 has five members, which the mesh hardly splits.
  EXPECT_LT(set.modes[4].omega / set.modes[0].omega, 1.02);
  EXPECT_GT(set.modes[5].omega / set.modes[4].omega, 1.05);
}

TEST(ShellModes, frequenciesFollowMaterialAndUnits) {
  const TriangleMesh plate = shapes::grid(8, 8);
  TriangleMesh inMillimetres = plate;
  for (Vec3& p : inMillimetres.positions) p *= 1000;
  Job job;
  const auto first = [&](const TriangleMesh& mesh, const ModesOptions& options) {
    return computeModes(mesh, options, job).modes[0].omega;
  };
  const double reference = first(plate, {ElasticModel::Shell, 3, {1e6, 0.3, 1000, 0.02, 1}});
  EXPECT_NEAR(first(inMillimetres, {ElasticModel::Shell, 3, {1e6, 0.3, 1000, 20, 0.001}}) / reference, 1,
              1e-7);
  EXPECT_NEAR(first(plate, {ElasticModel::Shell, 3, {4e6, 0.3, 1000, 0.02, 1}}) / reference, 2, 1e-7);
  EXPECT_NEAR(first(plate, {ElasticModel::Shell, 3, {1e6, 0.3, 4000, 0.02, 1}}) / reference, 0.5, 1e-7);
}

TEST(ShellModes, renumberingVerticesAndTurningFacesChangeNothing) {
  const TriangleMesh plate = shapes::jittered(shapes::grid(9, 7), 0.02, 5);
  TriangleMesh other;
  const uint32_t n = plate.vertexCount();
  for (uint32_t v = 0; v < n; ++v) other.positions.push_back(plate.positions[n - 1 - v]);
  for (const Triangle& t : plate.triangles)
    other.triangles.push_back({n - 1 - t[1], n - 1 - t[0], n - 1 - t[2]});
  Job job;
  const ModeSet a = computeModes(plate, unitShell(0.02), job), b = computeModes(other, unitShell(0.02), job);
  for (size_t k = 0; k < a.modes.size(); ++k) EXPECT_NEAR(a.modes[k].omega / b.modes[k].omega, 1, 1e-6);
}

TEST(ShellModes, partsVibrateOnTheirOwn) {
  TriangleMesh far = shapes::sphere(2, 0.5);
  for (Vec3& p : far.positions) p += Vec3{5, 0, 0};
  const TriangleMesh plate = shapes::grid(6, 6);
  Job job;
  const ModeSet both = computeModes(shapes::together(plate, far), unitShell(0.02, 4), job);
  const ModeSet first = computeModes(plate, unitShell(0.02, 4), job);
  const ModeSet second = computeModes(far, unitShell(0.02, 4), job);
  ASSERT_EQ(both.components.size(), 2u);
  ASSERT_EQ(both.modes.size(), 8u);
  for (const Mode& mode : both.modes) {
    const ModeSet& alone = mode.component == 0 ? first : second;
    EXPECT_NEAR(mode.omega / alone.modes[mode.ordinal].omega, 1, 1e-9);
  }
}

TEST(ShellModes, tinyAndNonManifoldPartsHaveTheModesTheyCan) {
  TriangleMesh triangle;
  triangle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  Job job;
  const ModeSet alone = computeModes(triangle, unitShell(0.02), job);
  EXPECT_EQ(alone.components[0].zeroModesFound, 6u);
  EXPECT_EQ(alone.modes.size(), 3u);

  TriangleMesh fan = triangle;  // three faces on one edge
  fan.positions.push_back({0, -1, 0.5});
  fan.positions.push_back({0, 0.2, 1});
  fan.triangles.push_back({1, 0, 3});
  fan.triangles.push_back({0, 1, 4});
  const ModeSet three = computeModes(fan, unitShell(0.02), job);
  EXPECT_EQ(three.components[0].zeroModesFound, 6u);
  for (const Mode& mode : three.modes) EXPECT_LE(mode.residual, 1e-7);
}

TEST(ShellModes, shapesAreScaledToALargestDisplacementOfOne) {
  Job job;
  const TriangleMesh plate = shapes::grid(6, 9);
  const ModeSet set = computeModes(plate, unitShell(0.02, 5), job);
  for (uint32_t ordinal = 0; ordinal < 5; ++ordinal) {
    double largest = 0;
    for (uint32_t v = 0; v < plate.vertexCount(); ++v) {
      const float* p = &set.shapes[(size_t{ordinal} * plate.vertexCount() + v) * 3];
      largest = std::max(largest, std::sqrt(double{p[0]} * p[0] + p[1] * p[1] + p[2] * p[2]));
    }
    EXPECT_NEAR(largest, 1, 1e-5);
  }
}

TEST(ShellModes, aCancelledSolveStops) {
  Job job;
  job.observer = [&](Phase phase, double) {
    if (phase == Phase::Solve) job.requestCancel();
  };
  EXPECT_THROW(computeModes(shapes::grid(16, 16), unitShell(0.02), job), Cancelled);
}

TEST(ShellModes, aUselessOptionIsRefusedWithASentence) {
  Job job;
  EXPECT_THROW(computeModes(shapes::grid(2, 2), unitShell(0), job), std::invalid_argument);
  EXPECT_THROW(computeModes(TriangleMesh{}, unitShell(0.1), job), std::invalid_argument);
}

}  // namespace
}  // namespace limber
