#include "fields/strain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "shapes.h"

namespace limber {
namespace {

using Motion = Vec3 (*)(const Vec3&);

// The displacement that takes every vertex to motion(vertex).
std::vector<float> displacement(const TriangleMesh& mesh, Motion motion) {
  std::vector<float> shape;
  for (const Vec3& p : mesh.positions) {
    const Vec3 d = motion(p) - p;
    for (int c = 0; c < 3; ++c) shape.push_back(static_cast<float>(d[c]));
  }
  return shape;
}

TEST(Strain, aRigidMotionHasNone) {
  const TriangleMesh mesh = shapes::torus(16, 8);
  const Motion rotateAndMove = [](const Vec3& p) {
    const double c = std::cos(1.1), s = std::sin(1.1);
    return Vec3{c * p.x - s * p.y + 3, s * p.x + c * p.y - 1, p.z + 0.5};
  };
  for (double strain : greenLagrangeStrain(mesh, displacement(mesh, rotateAndMove), 1))
    EXPECT_NEAR(strain, 0, 5e-6);  // shapes are float32
}

TEST(Strain, aStretchAlongOneAxisHasItsClosedForm) {
  const TriangleMesh sheet = shapes::grid(3, 4);
  const Motion stretch = [](const Vec3& p) { return Vec3{1.2 * p.x, p.y, p.z}; };
  for (double strain : greenLagrangeStrain(sheet, displacement(sheet, stretch), 1))
    EXPECT_NEAR(strain, (1.2 * 1.2 - 1) / 2, 1e-6);
}

TEST(Strain, aSimpleShearHasItsClosedForm) {
  const TriangleMesh sheet = shapes::grid(3, 4);
  const Motion shear = [](const Vec3& p) { return Vec3{p.x + 0.3 * p.y, p.y, p.z}; };
  // E = 1/2 [0 g; g g^2]
  const double g = 0.3, expected = 0.5 * std::sqrt(2 * g * g + g * g * g * g);
  for (double strain : greenLagrangeStrain(sheet, displacement(sheet, shear), 1))
    EXPECT_NEAR(strain, expected, 1e-6);
}

TEST(Strain, amplitudeScalesTheDisplacementNotTheStrain) {
  const TriangleMesh sheet = shapes::grid(2, 2);
  const Motion stretch = [](const Vec3& p) { return Vec3{2 * p.x, p.y, p.z}; };
  const double half = greenLagrangeStrain(sheet, displacement(sheet, stretch), 0.5)[0];
  EXPECT_NEAR(half, (1.5 * 1.5 - 1) / 2, 1e-6);
}

TEST(Strain, aTriangleWithoutAreaHasNone) {
  TriangleMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}, {0, 0, 1}};
  for (double strain : greenLagrangeStrain(line, std::vector<float>(9, 1.0f), 1)) EXPECT_EQ(strain, 0);
}

TEST(CombinedStrain, isEquationSixForEveryNorm) {
  const std::vector<WeightedStrain> ordinals = {{{1, 2, 3}, {0.5, 2}}, {{4, 0, 1}, {1, 3}}};
  const std::vector<uint32_t> component = {0, 0, 1};
  const auto sum = combineStrain(ordinals, component, 1);
  EXPECT_DOUBLE_EQ(sum[0], 0.5 * 1 + 1 * 4);
  EXPECT_DOUBLE_EQ(sum[2], 2 * 3 + 3 * 1);
  const auto euclidean = combineStrain(ordinals, component, 2);
  EXPECT_DOUBLE_EQ(euclidean[0], std::sqrt(0.5 * 1 + 1 * 16));
  const auto largest = combineStrain(ordinals, component, std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(largest[0], 4);
  EXPECT_DOUBLE_EQ(largest[1], 1);
  EXPECT_DOUBLE_EQ(largest[2], 6);
}

TEST(CombinedStrain, isANumberWhateverIsInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<WeightedStrain> ordinals = {{{0, 1, 1e200}, {kInfinity, 0}}};
  const std::vector<uint32_t> component = {0, 0, 1};
  for (const double p : {2.0, kInfinity}) {
    const auto combined = combineStrain(ordinals, component, p);
    EXPECT_EQ(combined[0], 0);
    EXPECT_EQ(combined[1], kInfinity);
    EXPECT_EQ(combined[2], 0);
  }
}

TEST(Strain, thatIsTooLargeForANumberIsNone) {
  TriangleMesh needle;
  needle.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1e-300, 0}};
  needle.triangles = {{0, 1, 2}};
  const std::vector<float> shape = {0, 0, 0, 0, 0, 0, 1, 1, 0};
  EXPECT_EQ(greenLagrangeStrain(needle, shape, 1)[0], 0);
}

TEST(Rank, countsThoseBelowAndHalfOfTheTies) {
  const std::vector<double> values = {5, 1, 5, 9, 7, 7};
  const std::vector<uint32_t> group = {0, 0, 0, 0, 1, 1};
  const auto rank = rankWithin(values, group, 2);
  EXPECT_FLOAT_EQ(rank[1], 0.5f / 4);
  EXPECT_FLOAT_EQ(rank[0], 2.0f / 4);  // one below, two tied
  EXPECT_FLOAT_EQ(rank[2], rank[0]);
  EXPECT_FLOAT_EQ(rank[3], 3.5f / 4);
  EXPECT_FLOAT_EQ(rank[4], 0.5f);
  EXPECT_FLOAT_EQ(rank[5], 0.5f);
}

TEST(Strain, isTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = shapes::jittered(shapes::sphere(5), 0.002, 3);
  const Motion bend = [](const Vec3& p) { return Vec3{p.x, p.y + 0.2 * p.x * p.x, p.z}; };
  const auto shape = displacement(mesh, bend);
  const auto one = greenLagrangeStrain(mesh, shape, 1);
  for (int threads : {2, 4}) {
    setThreadCount(threads);
    EXPECT_EQ(greenLagrangeStrain(mesh, shape, 1), one);
  }
  setThreadCount(1);
}

}  // namespace
}  // namespace limber
