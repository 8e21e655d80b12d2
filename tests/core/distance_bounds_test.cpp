#include "fit/search/distance_bounds.h"

#include <gtest/gtest.h>

#include "query/closest_point.h"
#include "shapes.h"

namespace limber {
namespace {

double distanceFrom(const TriangleMesh& surface, const Vec3& point) {
  return ClosestPointTree(surface).closest(point).distance;
}

// Two equal sheets with cells of 0.1; the mean length of the edges around a vertex is between 0.1 and 0.15.
struct Sheets {
  TriangleMesh surface = shapes::grid(10, 10, 1, 1), start = surface;
};

TEST(DistanceBounds, letVerticesMoveAlongTheSurfaceAndALittleOffIt) {
  const auto [surface, start] = Sheets{};
  const ClosestPointTree tree(surface);
  const DistanceBounds bounds(tree, start, buildTopology(start));
  for (const Vec3& target : {Vec3{0.5, 0.5, 0.004}, Vec3{0.1, 0.9, 0}, Vec3{0.31, 0.72, -0.003}})
    EXPECT_EQ(bounds.limited(60, target), target);
}

TEST(DistanceBounds, stopVerticesAtATwentiethOfTheirEdges) {
  const auto [surface, start] = Sheets{};
  const ClosestPointTree tree(surface);
  const DistanceBounds bounds(tree, start, buildTopology(start));
  for (const double height : {0.02, 0.1, -0.5}) {
    const Vec3 there = bounds.limited(60, {0.42, 0.55, height});
    EXPECT_NEAR(there.x, 0.42, 1e-12);
    EXPECT_NEAR(there.y, 0.55, 1e-12);
    EXPECT_GT(there.z * height, 0);
    EXPECT_GE(std::abs(there.z), 0.05 * 0.1);
    EXPECT_LE(std::abs(there.z), 0.05 * 0.15);
  }
  // The same holds beyond the border.
  const Vec3 beyond = bounds.limited(0, {-0.3, -0.4, 0});
  EXPECT_LE(length(beyond), 0.05 * 0.15);
  EXPECT_NEAR(beyond.y / beyond.x, 4.0 / 3, 1e-9);
}

TEST(DistanceBounds, letVerticesKeepTheirDistanceAtTheStart) {
  auto [surface, start] = Sheets{};
  start.positions[60].z = 0.08;
  const ClosestPointTree tree(surface);
  const DistanceBounds bounds(tree, start, buildTopology(start));
  EXPECT_EQ(bounds.limited(60, {0.45, 0.5, 0.079}), (Vec3{0.45, 0.5, 0.079}));
  EXPECT_NEAR(distanceFrom(surface, bounds.limited(60, {0.45, 0.5, 0.2})), 0.08, 1e-12);
  EXPECT_LT(distanceFrom(surface, bounds.limited(61, {0.45, 0.5, 0.2})), 0.02);
}

}  // namespace
}  // namespace limber
