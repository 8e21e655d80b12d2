#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "elastic/mode_character.h"
#include "elastic/modes.h"
#include "elastic/pins.h"
#include "elastic/refine_pinned_faces.h"
#include "mesh/eigen_vec3.h"
#include "mesh/topology.h"
#include "shapes.h"

namespace limber {
namespace {

TEST(Pins, leaveTheRigidMotionsThatTheyDoNotPrevent) {
  EXPECT_EQ(rigidMotionsLeft({}), 6u);
  EXPECT_EQ(rigidMotionsLeft({{1, 2, 3}}), 3u);
  EXPECT_EQ(rigidMotionsLeft({{0, 0, 0}, {1, 1, 0}, {0.5, 0.5, 0}}), 1u);
  EXPECT_EQ(rigidMotionsLeft({{0, 0, 0}, {1, 1, 0}, {0.5, 0.4, 0}}), 0u);
}

class PinnedSheet : public testing::TestWithParam<std::vector<uint32_t>> {};

TEST_P(PinnedSheet, hasTheZeroModesThatItsPinsLeave) {
  const TriangleMesh mesh = shapes::grid(9, 7);
  ModesOptions options{ElasticModel::Shell, 4, unitMaterial(0.02)};
  options.pinned = GetParam();
  Job job;
  const ModeSet set = computeModes(mesh, options, job);
  EXPECT_EQ(set.components[0].zeroModesFound, set.components[0].zeroModesExpected);
  for (const Mode& mode : set.modes) EXPECT_LE(mode.residual, 1e-7);
  for (uint32_t ordinal = 0; ordinal < 4; ++ordinal)
    for (uint32_t v : options.pinned)
      for (uint32_t c = 0; c < 3; ++c)
        EXPECT_EQ(set.shapes[(size_t{ordinal} * mesh.vertexCount() + v) * 3 + c], 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Corners, PinnedSheet,
                         testing::Values(std::vector<uint32_t>{}, std::vector<uint32_t>{0},
                                         std::vector<uint32_t>{0, 9}, std::vector<uint32_t>{0, 9, 70},
                                         std::vector<uint32_t>{0, 1, 2, 3, 4}));

TEST(PinnedModes, ofAPlateClampedAllAroundAreThoseOfTheTables) {
  // A strip of cells around the unit square is pinned too, which clamps its edge rotations.
  const int cells = 34;
  TriangleMesh mesh = shapes::grid(cells, cells, cells / 32.0, cells / 32.0);
  const double thickness = 0.01;
  ModesOptions options{ElasticModel::Shell, 3, unitMaterial(thickness)};
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const double x = mesh.positions[v].x - 1 / 32.0, y = mesh.positions[v].y - 1 / 32.0;
    if (x < 1e-9 || y < 1e-9 || x > 1 - 1e-9 || y > 1 - 1e-9) options.pinned.push_back(v);
  }
  Job job;
  const ModeSet set = computeModes(mesh, options, job);
  // Leissa 1969: omega a^2 sqrt(rho h / D).
  const double expected[] = {35.985, 73.394, 73.394};
  const double scale = std::sqrt(12 * (1 - 0.09)) / thickness;
  for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(set.modes[k].omega * scale / expected[k], 1, 0.03);
  EXPECT_EQ(set.components[0].zeroModesExpected, 0u);
}

TEST(PinnedModes, ofALaplacianHaveNoZeroMode) {
  const TriangleMesh mesh = shapes::grid(30, 4, 7.5, 1);
  ModesOptions options{ElasticModel::Laplacian, 6, unitMaterial(0.02)};
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].x == 0) options.pinned.push_back(v);
  Job job;
  ModeSet set = computeModes(mesh, options, job);
  EXPECT_EQ(set.components[0].zeroModesExpected, 0u);
  EXPECT_EQ(set.components[0].zeroModesFound, 0u);
  // A quarter wave, then three quarters: 1 to 3.
  EXPECT_NEAR(set.modes[3].omega / set.modes[0].omega, 3, 0.1);
  options.direction = 1;
  set = computeModes(mesh, options, job);
  EXPECT_NEAR(set.modes[1].omega / set.modes[0].omega, 3, 0.1);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(set.shapes[3 * v], 0.0f);
    EXPECT_EQ(set.shapes[3 * v + 2], 0.0f);
  }
}

TEST(PinnedModes, ofAPartWithAllVerticesPinnedAreNone) {
  const TriangleMesh sheet = shapes::grid(4, 4);
  TriangleMesh other = sheet;
  for (Vec3& p : other.positions) p.z += 1;
  const TriangleMesh mesh = shapes::together(sheet, other);
  ModesOptions options{ElasticModel::Shell, 2, unitMaterial(0.02)};
  for (uint32_t v = 0; v < sheet.vertexCount(); ++v) options.pinned.push_back(v);
  Job job;
  const ModeSet set = computeModes(mesh, options, job);
  EXPECT_EQ(set.components[0].modeCount, 0u);
  EXPECT_EQ(set.components[0].zeroModesExpected, 0u);
  EXPECT_EQ(set.components[1].modeCount, 2u);
  options.pinned = {1000};
  EXPECT_THROW(computeModes(mesh, options, job), std::invalid_argument);
}

// Solved densely, but not over the unknowns that the pins fix: these would take gigabytes.
TEST(PinnedModes, ofAFewFreeVerticesAreThoseOfTheirSurroundings) {
  const auto solve = [](int cells) {
    const TriangleMesh mesh = shapes::grid(cells, cells, 0.01 * cells, 0.01 * cells);
    ModesOptions options{ElasticModel::Shell, 4, unitMaterial(0.001)};
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
      if (mesh.positions[v].x > 0.035 || mesh.positions[v].y > 0.035) options.pinned.push_back(v);
    Job job;
    return computeModes(mesh, options, job);
  };
  const ModeSet small = solve(8), large = solve(80);
  ASSERT_EQ(large.modes.size(), 4u);
  for (size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(large.modes[k].omega / small.modes[k].omega, 1, 1e-6);
    EXPECT_LE(large.modes[k].residual, 1e-7);
  }
}

TEST(PinnedModes, ofASolidCantileverDoNotDependOnHowManyVerticesItsEndHas) {
  // 1 x 1 x 6, E = rho = 1, nu = 0.3: Timoshenko's first bend; Euler and Bernoulli's would be 2 % higher.
  double first[2] = {};
  for (int k = 0; k < 2; ++k) {
    const int cells = k == 0 ? 1 : 8;
    const TriangleMesh mesh = shapes::box(cells, cells, 6 * cells, 1.0 / cells);
    ModesOptions options{ElasticModel::Auto, 4, unitMaterial(0.02)};
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
      if (mesh.positions[v].z == 0) options.pinned.push_back(v);
    Job job;
    const ModeSet set = computeModes(mesh, options, job);
    EXPECT_EQ(set.components[0].model, ElasticModel::Solid);
    EXPECT_EQ(set.components[0].zeroModesFound, 0u);
    for (const Mode& mode : set.modes) EXPECT_LE(mode.residual, 1e-7);
    first[k] = set.modes[0].omega;
  }
  const double euler = std::pow(1.8751, 2) / 36 * std::sqrt(1.0 / 12);
  EXPECT_NEAR(first[1] / euler, 0.98, 0.02);
  EXPECT_NEAR(first[0] / first[1], 1, 0.03);
}

TEST(PinnedPatch, isSplitWithoutACrackUntilItsEdgesAreShort) {
  TriangleMesh mesh = shapes::box(1, 1, 3, 1);
  std::vector<uint32_t> pinned;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].z == 0) pinned.push_back(v);
  const TriangleMesh before = mesh;
  refinePinnedFaces(mesh, pinned, 0.2);
  for (uint32_t v = 0; v < before.vertexCount(); ++v) EXPECT_EQ(mesh.positions[v], before.positions[v]);
  for (const auto& edge : buildTopology(mesh).edges) {
    EXPECT_EQ(edge.useCount, 2u);
    const Vec3 a = mesh.positions[edge.a], b = mesh.positions[edge.b];
    EXPECT_TRUE(a.z != 0 || b.z != 0 || length(b - a) <= 0.2);
  }
  double area = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) area += triangleArea(mesh, t);
  EXPECT_NEAR(area, 14, 1e-9);
  for (uint32_t v : pinned) EXPECT_EQ(mesh.positions[v].z, 0);
}

Eigen::VectorXd asColumn(const std::vector<Vec3>& shape) {
  Eigen::VectorXd column(3 * static_cast<Eigen::Index>(shape.size()));
  for (size_t v = 0; v < shape.size(); ++v)
    column.segment<3>(3 * static_cast<Eigen::Index>(v)) = eigen(shape[v]);
  return column;
}

TEST(ModeNames, tellBendingTwistingStretchingBreathingAndLocalMotionApart) {
  const TriangleMesh bar = shapes::box(4, 4, 12, 0.25);
  const ModeObserver observer(bar);
  const auto name = [&](const auto& field) {
    std::vector<Vec3> shape;
    for (const Vec3& p : bar.positions) shape.push_back(field(p - Vec3{0.5, 0.5, 1.5}));
    return nameOf(observer.observe(asColumn(shape)));
  };
  const double k = std::numbers::pi / 3;
  EXPECT_EQ(name([&](const Vec3& p) { return Vec3{std::cos(k * p.z), 0, -k * p.x * -std::sin(k * p.z)}; }),
            ModeName::Bend);
  EXPECT_EQ(name([&](const Vec3& p) { return std::sin(k * p.z) * Vec3{-p.y, p.x, 0}; }), ModeName::Twist);
  EXPECT_EQ(name([&](const Vec3& p) {
              return Vec3{-0.3 * k * p.x * std::cos(k * p.z), -0.3 * k * p.y * std::cos(k * p.z),
                          std::sin(k * p.z)};
            }),
            ModeName::Stretch);
  EXPECT_EQ(name([&](const Vec3& p) { return p.z > 1.4 && p.x > 0.4 ? Vec3{0, 0, 1} : Vec3{}; }),
            ModeName::Local);
  const TriangleMesh ball = shapes::sphere(3);
  EXPECT_EQ(nameOf(ModeObserver(ball).observe(asColumn(ball.positions))), ModeName::Breathe);
}

// A square has no longest axis: names refer to its first side, for any triangulation.
TEST(ModeNames, ofASquareGoByItsSides) {
  const TriangleMesh square = shapes::grid(20, 20);
  const ModeObserver observer(square);
  const auto name = [&](const auto& height) {
    std::vector<Vec3> shape;
    for (const Vec3& p : square.positions) shape.push_back({0, 0, height(p.x - 0.5, p.y - 0.5)});
    return nameOf(observer.observe(asColumn(shape)));
  };
  EXPECT_EQ(name([](double x, double y) { return x * y; }), ModeName::Twist);
  EXPECT_EQ(name([](double x, double y) { return x * x - y * y; }), ModeName::Bend);
}

}  // namespace
}  // namespace limber
