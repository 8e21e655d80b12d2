#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/parallel.h"
#include "compare/surface_distance.h"
#include "mesh/quality.h"
#include "mesh/surface_samples.h"
#include "query/closest_point.h"
#include "shapes.h"

namespace limber {
namespace {

SurfaceDistance distanceOf(const TriangleMesh& a, const TriangleMesh& b) {
  Job job;
  return measureSurfaceDistance(a, b, {}, job);
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p += by;
  return mesh;
}

TriangleMesh turnedOver(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// The distance of a point to a triangle by dense search: an upper bound, too large by less than `step` of an
// edge.
double bruteForce(const Vec3& p, const TriangleMesh& mesh, uint32_t t) {
  double best = HUGE_VAL;
  const int steps = 60;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j) {
      const double u = double(i) / steps, v = double(j) / steps;
      best = std::min(best, length(p - (mesh.corner(t, 0) * (1 - u - v) + mesh.corner(t, 1) * u +
                                        mesh.corner(t, 2) * v)));
    }
  return best;
}

TEST(Quality, isOneForAnEquilateralTriangleAndZeroWithoutArea) {
  const double h = std::sqrt(3.0) / 2;
  EXPECT_NEAR(triangleQuality({0, 0, 0}, {1, 0, 0}, {0.5, h, 0}), 1, 1e-12);
  EXPECT_NEAR(smallestAngle({0, 0, 0}, {1, 0, 0}, {0.5, h, 0}), 60, 1e-9);
  EXPECT_EQ(triangleQuality({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
  EXPECT_EQ(smallestAngle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
  EXPECT_EQ(triangleQuality({0, 0, 0}, {0, 0, 0}, {0, 0, 0}), 0);
}

TEST(Quality, ofTheBarIsThatOfRightIsoscelesTriangles) {
  const TriangleMesh bar = shapes::box(2, 2, 3, 0.5);
  const QualityReport report = measureQuality(bar);
  EXPECT_NEAR(report.minAngle, 45, 1e-9);
  EXPECT_NEAR(report.meanMinAngle, 45, 1e-9);
  for (uint32_t t = 0; t < bar.triangleCount(); ++t)
    EXPECT_NEAR(triangleQuality(bar.corner(t, 0), bar.corner(t, 1), bar.corner(t, 2)), std::sqrt(3.0) / 2,
                1e-12);
}

TEST(Quality, ofTwoTrianglesAtOnceIsTheSquareOfEach) {
  const Vec3 p{0.1, 0.2, -0.4}, q{1.3, 0.1, 0.2}, r{0.4, 0.9, 0.3}, s{0.1, 0.2, -0.4};
  const RealPair squares = squaredTriangleQuality(asPair(p, p), asPair(q, q), asPair(r, s));
  EXPECT_NEAR(squares[0], std::pow(triangleQuality(p, q, r), 2), 1e-14);
  EXPECT_EQ(squares[1], 0);
}

TEST(ClosestPoint, agreesWithADenseSearchOnAnyTriangle) {
  TriangleMesh mesh = shapes::jittered(shapes::box(1, 1, 2, 1), 0.3, 5);
  mesh.triangles.push_back({0, 1, 1});  // a segment
  mesh.triangles.push_back({2, 2, 2});  // a point
  const ClosestPointTree tree(mesh);
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const auto coordinate = [&] { return 4.0 * random() / 4294967295.0 - 1; };
    const Vec3 p{coordinate(), coordinate(), coordinate()};
    double best = HUGE_VAL;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) best = std::min(best, bruteForce(p, mesh, t));
    const ClosestPoint found = tree.closest(p);
    EXPECT_LE(found.distance, best + 1e-12);
    EXPECT_GE(found.distance, best - 0.02);
    EXPECT_NEAR(length(p - found.position), found.distance, 1e-12);
    EXPECT_NEAR(found.barycentric[0] + found.barycentric[1] + found.barycentric[2], 1, 1e-12);
    for (double weight : found.barycentric) EXPECT_GE(weight, 0);
    const auto near = static_cast<uint32_t>(random() % mesh.triangleCount());
    const ClosestPoint again = tree.closest(p, near);
    EXPECT_EQ(again.triangle, found.triangle);
    EXPECT_EQ(again.distance, found.distance);
    EXPECT_EQ(again.position.x, found.position.x);
  }
}

// Needles from a hub to a wavy rim.
TriangleMesh fan(uint32_t needles) {
  TriangleMesh mesh = {{{0, 0, 0.02}}, {}};
  for (uint32_t i = 0; i < needles; ++i) {
    const double angle = 2 * std::numbers::pi * i / needles;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0.05 * std::cos(5 * angle)});
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % needles});
  }
  return mesh;
}

TEST(ClosestPoint, isFoundAmongNeedlesAsAmongOtherTriangles) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.1, 1.1);
  const TriangleMesh mesh = fan(1000);
  const ClosestPointTree tree(mesh);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = {any(random), any(random), 0.1 * any(random)};
    double least = HUGE_VAL;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
      least = std::min(least, closestOnTriangle(mesh, t, p).distance);
    EXPECT_NEAR(tree.closest(p).distance, least, 1e-15);
  }
}

// The box of a needle oblique to the axes is mostly empty, so that a quarter of all boxes would overlap at a
// point.
TEST(ClosestPoint, meetsFewNeedlesOfAFan) {
  const TriangleMesh mesh = fan(4096);
  const BoundingTree tree = treeOver(mesh);
  size_t visits = 0;
  constexpr size_t kPoints = 100;
  for (size_t i = 0; i < kPoints; ++i) {
    const double angle = 0.3 + 2 * std::numbers::pi * i / kPoints, radius = 0.3 + 0.006 * i;
    const Vec3 p = {radius * std::cos(angle), radius * std::sin(angle), 0};
    tree.forEachWithin(p, 0, [&](uint32_t) {
      ++visits;
      return 0.0;
    });
  }
  EXPECT_LT(visits, 64 * kPoints);
}

// Corners whose coordinates differ by many powers of ten make triangles without a height, whose normal is
// pure rounding error.
TEST(ClosestPoint, ofANeedleLiesBetweenItsCorners) {
  std::mt19937 random(3);
  const auto share = [&] { return 2.0 * random() / 4294967295.0 - 1; };
  const auto coordinate = [&] { return share() * std::pow(10, 20 * share()); };
  const auto place = [&] { return Vec3{coordinate(), coordinate(), coordinate()}; };
  for (int trial = 0; trial < 20000; ++trial) {
    const TriangleMesh needle = {{place(), place(), place()}, {{0, 1, 2}}};
    const Vec3 p = place();
    const ClosestPoint found = closestOnTriangle(needle, 0, p);
    double sum = 0, size = length(p);
    for (const double weight : found.barycentric) {
      EXPECT_GE(weight, 0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1, 1e-8);
    for (const Vec3& corner : needle.positions) size = std::max(size, length(corner));
    for (const Vec3& corner : needle.positions) EXPECT_LE(found.distance, length(p - corner) + 1e-6 * size);
    const Vec3 position = closestPosition(p, needle.positions[0], needle.positions[1], needle.positions[2]);
    EXPECT_NEAR(length(p - position), found.distance, 1e-6 * size);
  }
}

TEST(SurfaceDistance, ofParallelSheetsIsTheirGap) {
  const TriangleMesh sheet = shapes::grid(5, 5);
  const SurfaceDistance distance = distanceOf(sheet, moved(sheet, {0, 0, 0.25}));
  EXPECT_NEAR(distance.hausdorff, 0.25, 1e-12);
  EXPECT_NEAR(distance.mean, 0.25, 1e-12);
  EXPECT_NEAR(distance.vertexHausdorff, 0.25, 1e-12);
}

TEST(SurfaceDistance, ofConcentricSpheresIsTheDifferenceOfTheirRadii) {
  const SurfaceDistance distance = distanceOf(shapes::sphere(5, 1), shapes::sphere(5, 1.2));
  EXPECT_NEAR(distance.mean, 0.2, 0.002);
  EXPECT_NEAR(distance.hausdorff, 0.2, 0.005);
}

TEST(SurfaceDistance, isZeroForAFinerMeshOfTheSameSurface) {
  const SurfaceDistance distance = distanceOf(shapes::grid(4, 4), shapes::grid(8, 8));
  EXPECT_NEAR(distance.hausdorff, 0, 1e-12);
  EXPECT_NEAR(distance.vertexHausdorff, std::sqrt(2.0) / 8, 1e-12);
}

TEST(SurfaceDistance, isSymmetricAndSeesWhatOnlyOneSideHas) {
  const TriangleMesh a = shapes::grid(4, 4),
                     b = shapes::together(a, moved(shapes::grid(1, 1, 0.1, 0.1), {0, 0, 3}));
  EXPECT_NEAR(distanceOf(a, b).hausdorff, 3, 1e-12);
  EXPECT_NEAR(distanceOf(b, a).hausdorff, 3, 1e-12);
  EXPECT_EQ(distanceOf(a, b).mean, distanceOf(b, a).mean);
}

TEST(SurfaceDistance, isTheSameForAnyNumberOfThreads) {
  const TriangleMesh a = shapes::sphere(4), b = shapes::jittered(shapes::sphere(3), 0.02, 9);
  const SurfaceDistance one = distanceOf(a, b);
  for (int threads : {2, 4}) {
    setThreadCount(threads);
    const SurfaceDistance other = distanceOf(a, b);
    EXPECT_EQ(other.hausdorff, one.hausdorff);
    EXPECT_EQ(other.mean, one.mean);
  }
  setThreadCount(1);
}

TEST(ClosestPoint, tellsSheetsApartByTheirNormals) {
  const TriangleMesh above = shapes::grid(4, 4), near = moved(turnedOver(above), {0, 0, -0.005});
  const Vec3 up{0, 0, 1}, down{0, 0, -1}, point{0.4, 0.3, -0.004};
  for (const TriangleMesh& below : {turnedOver(above), near}) {
    const TriangleMesh sheets = shapes::together(above, below);
    const ClosestPointTree tree(sheets);
    EXPECT_LT(tree.closestFacing(point, up).triangle, above.triangleCount());
    EXPECT_GE(tree.closestFacing(point, down).triangle, above.triangleCount());
    EXPECT_NEAR(tree.closestFacing(point, up).distance, 0.004, 1e-12);
    EXPECT_EQ(tree.closestFacing(point, {}).triangle, tree.closest(point).triangle);
  }
}

TEST(ClosestPoint, ofASheetFarBehindIsNotTaken) {
  const TriangleMesh above = shapes::grid(4, 4);
  const Vec3 up{0, 0, 1}, point{0.4, 0.3, 0.001};
  const TriangleMesh alone = turnedOver(above), apart = shapes::together(alone, moved(above, {0, 0, -0.1}));
  EXPECT_NEAR(ClosestPointTree(alone).closestFacing(point, up).distance, 0.001, 1e-12);
  EXPECT_LT(ClosestPointTree(apart).closestFacing(point, up).triangle, above.triangleCount());
}

TEST(SurfaceSamples, areSpreadByArea) {
  // A large and a small square: 4 to 1 by area.
  const TriangleMesh squares =
      shapes::together(shapes::grid(1, 1, 2, 2), moved(shapes::grid(3, 3), {10, 0, 0}));
  int far = 0;
  for (const Vec3& p : sampleSurface(squares, 10'000).positions) far += p.x > 5;
  EXPECT_NEAR(far, 2000, 2);
}

TEST(SurfaceDistance, ofTheLargestAloneIsThatOfAll) {
  Job job;
  const TriangleMesh ball = shapes::sphere(3, 1), bumpy = shapes::jittered(ball, 0.2, 3);
  const TriangleMesh box = shapes::box(3, 3, 3, 0.4);
  for (const auto& [a, b] : {std::pair(ball, bumpy), std::pair(ball, box),
                             std::pair(box, moved(box, {1, 2, 3})), std::pair(bumpy, bumpy)})
    for (const uint32_t samples : {0u, 300u}) {
      const double all = measureSurfaceDistance(a, b, {.samples = samples}, job).hausdorff;
      EXPECT_NEAR(measureHausdorff(a, b, {.samples = samples}, job), all, 1e-15 * (1 + all));
      EXPECT_TRUE(isWithinHausdorff(a, b, all * (1 + 1e-9), {.samples = samples}, job));
      if (all > 0) {
        EXPECT_FALSE(isWithinHausdorff(a, b, all * (1 - 1e-9), {.samples = samples}, job));
      }
    }
  EXPECT_EQ(measureHausdorff(ball, {}, {}, job), 0);
}

TEST(ClosestPoint, isAnyNearEnoughOneOrTheClosest) {
  const TriangleMesh mesh = shapes::jittered(shapes::box(4, 4, 4, 0.5), 0.3, 5);
  const ClosestPointTree tree(mesh);
  std::mt19937 random(4);
  int early = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const auto coordinate = [&] { return 4.0 * random() / 4294967295.0 - 1; };
    const Vec3 p{coordinate(), coordinate(), coordinate()};
    const ClosestPoint closest = tree.closest(p);
    const uint32_t near = trial % 3 == 0 ? kNone : static_cast<uint32_t>(random() % mesh.triangleCount());
    const double enough = closest.distance * (trial % 2 == 0 ? 0.999 : 1.5);
    const ClosestPoint found = tree.nearEnough(p, enough, near);
    if (trial % 2 == 0) {
      EXPECT_EQ(found.triangle, closest.triangle);
      EXPECT_EQ(found.distance, closest.distance);
      continue;
    }
    EXPECT_LE(found.distance, enough * (1 + 1e-15));
    EXPECT_NEAR(length(found.position - p), found.distance, 1e-14);
    early += found.triangle != closest.triangle;
  }
  EXPECT_GT(early, 0);
}

// The middle of the ridge of a roof of four large triangles is farthest from a valley that crosses below it.
TEST(SurfaceDistance, isFoundOnAnEdge) {
  const TriangleMesh roof{{{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0.3}, {0, 0.5, 0.3}, {1, 1, 0}, {0, 1, 0}},
                          {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}};
  TriangleMesh valley = shapes::grid(8, 8);
  for (Vec3& p : valley.positions) p.z = -0.1 * (1 - std::abs(2 * p.x - 1));
  const double expected = 0.4 / std::sqrt(1.04);
  Job job;
  const SurfaceDistanceOptions few{.samples = 10};
  EXPECT_NEAR(measureSurfaceDistance(roof, valley, few, job).hausdorff, expected, 1e-9);
  EXPECT_NEAR(measureHausdorff(valley, roof, few, job), expected, 1e-9);
  EXPECT_FALSE(isWithinHausdorff(roof, valley, 0.999 * expected, few, job));
  EXPECT_TRUE(isWithinHausdorff(roof, valley, 1.001 * expected, few, job));
}

TEST(SurfaceSamples, ofEdgesAreCloseTogetherAndInTheMiddle) {
  const TriangleMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  const auto inside = [&](double spacing) {
    std::vector<double> found;
    for (const Vec3& p : sampleEdges(one, spacing))
      if (std::abs(p.x + p.y - 1) < 1e-12 && p.x > 0 && p.x < 1) found.push_back(p.x);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  };
  EXPECT_EQ(inside(10), std::vector<double>{0.5});
  EXPECT_EQ(inside(0.5), (std::vector<double>{0.25, 0.5, 0.75}));
  EXPECT_EQ(inside(1e-9).size(), 63u);
}

}  // namespace
}  // namespace limber
