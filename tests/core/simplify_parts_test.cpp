#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <span>

#include "query/nearest.h"
#include "simplify/collapse_mesh.h"
#include "simplify/cost/qem.h"
#include "simplify/edge_queue.h"
#include "simplify/quadric.h"
#include "surfaces.h"

// Tests of the parts of the collapse loop.

namespace limber {
namespace {

double uniform(std::mt19937& random) {
  return random() / 4294967296.0;
}

TEST(Quadric, measuresTheMeanSquaredDistanceToItsPlanes) {
  Quadric q = planeQuadric({0, 0, 1}, {5, 5, 2}, 3) + planeQuadric({1, 0, 0}, {1, 0, 0}, 1);
  q.area = 4;
  EXPECT_NEAR(normalizedError(q, Point<double>{4, 7, 3}), (3 * 1.0 + 1 * 9.0) / 4, 1e-12);
  EXPECT_EQ(normalizedError(q, Point<double>{1, -3, 2}), 0);
}

TEST(Quadric, isLeastWhereThreePlanesMeet) {
  const Vec3 corner{0.3, -0.2, 0.7};
  const Quadric q = planeQuadric({1, 0, 0}, corner, 1) + planeQuadric({0, 1, 0}, corner, 0.5) +
                    planeQuadric(normalized({1, 1, 1}), corner, 2);
  const Vec3 found = asVec3(minimize(q, Point<double>{1, 1, 1}));
  EXPECT_LT(length(found - corner), 1e-7);
}

TEST(Quadric, movesNoFartherThanItsPlanesAsk) {
  const Quadric plane = planeQuadric({0, 0, 1}, {0, 0, 2}, 3);
  const Vec3 onPlane = asVec3(minimize(plane, Point<double>{4, 5, 6}));
  EXPECT_LT(length(onPlane - Vec3{4, 5, 2}), 1e-8);
  const Quadric crease = plane + planeQuadric({0, 1, 0}, {0, 1, 0}, 1);
  const Vec3 onCrease = asVec3(minimize(crease, Point<double>{4, 5, 6}));
  EXPECT_LT(length(onCrease - Vec3{4, 1, 2}), 1e-7);
  const Vec3 nowhere = asVec3(minimize(Quadric{}, Point<double>{4, 5, 6}));
  EXPECT_EQ(nowhere, (Vec3{4, 5, 6}));
}

// Sets, removes and underestimates costs, and compares with a sorted set of the true costs.
TEST(EdgeQueue, givesTheCheapestFirstAndTheLowerOnATie) {
  constexpr uint32_t kEdges = 300;
  for (uint32_t seed = 1; seed <= 5; ++seed) {
    std::mt19937 random(seed);
    EdgeQueue queue(kEdges);
    std::vector<float> cost(kEdges, -1);
    std::set<std::pair<float, uint32_t>> expected;
    const auto price = [&](std::span<const uint32_t> edges) {
      for (const uint32_t edge : edges) queue.set(edge, cost[edge]);
    };
    const auto change = [&](uint32_t edge, float to) {
      expected.erase({cost[edge], edge});
      expected.insert({cost[edge] = to, edge});
    };
    for (int step = 0; step < 4000; ++step) {
      const uint32_t edge = random() % kEdges;
      const uint32_t what = random() % 8;
      if (what < 3) {
        change(edge, static_cast<float>(random() % 50) / 3);
        queue.set(edge, cost[edge]);
      } else if (what < 5 && queue.isWaiting(edge)) {
        change(edge, static_cast<float>(random() % 50) / 3);
        queue.markStale(edge, cost[edge] * 0.1 * (random() % 11));
      } else if (what == 5) {
        expected.erase({cost[edge], edge});
        queue.remove(edge);
      } else if (!expected.empty()) {
        ASSERT_TRUE(queue.findFirst(price));
        const float other = static_cast<float>(random() % 50) / 3;
        ASSERT_EQ(queue.wouldBeFirst(kEdges, other), other < expected.begin()->first);
        ASSERT_EQ(queue.pop(), expected.begin()->second) << "seed " << seed << ", step " << step;
        expected.erase(expected.begin());
      }
      ASSERT_EQ(queue.isWaiting(edge), expected.contains({cost[edge], edge}));
    }
    for (; !expected.empty(); expected.erase(expected.begin())) {
      ASSERT_TRUE(queue.findFirst(price));
      ASSERT_EQ(queue.pop(), expected.begin()->second) << "seed " << seed;
    }
    EXPECT_FALSE(queue.findFirst(price));
  }
}

// A point in the bounding box of a torus, or a little outside.
Vec3 nearTorus(std::mt19937& random) {
  const double x = 3 * uniform(random) - 1.5, y = 3 * uniform(random) - 1.5;
  return {x, y, uniform(random) - 0.5};
}

TEST(NearestVertex, isThatOfAPlainSearch) {
  const TriangleMesh mesh = shapes::jittered(shapes::torus(20, 11), 0.05, 8);
  const NearestVertex nearest(mesh);
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = nearTorus(random);
    uint32_t expected = 0;
    for (uint32_t v = 1; v < mesh.vertexCount(); ++v)
      if (squaredLength(p - mesh.positions[v]) < squaredLength(p - mesh.positions[expected])) expected = v;
    ASSERT_EQ(nearest.find(p, random() % mesh.vertexCount()), expected) << i;
  }
}

// The distance from p to a triangle, by a fine sampling that shares nothing with the search.
double sampledDistance(const TriangleMesh& mesh, uint32_t t, const Vec3& p) {
  constexpr int kSteps = 60;
  double least = 1e9;
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; i + j <= kSteps; ++j) {
      const double u = 1.0 * i / kSteps, v = 1.0 * j / kSteps;
      const Vec3 q = mesh.corner(t, 0) * u + mesh.corner(t, 1) * v + mesh.corner(t, 2) * (1 - u - v);
      least = std::min(least, length(p - q));
    }
  return least;
}

TEST(NearestTriangle, isNoFartherThanAnyOther) {
  const TriangleMesh mesh = shapes::jittered(shapes::torus(9, 6), 0.1, 8);
  const NearestTriangle nearest(mesh);
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    const Vec3 p = nearTorus(random);
    const uint32_t found = nearest.find(p, random() % mesh.triangleCount());
    double least = 1e9;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) least = std::min(least, sampledDistance(mesh, t, p));
    // Samples lie up to 1/60 of an edge from the nearest point, which matters little away from the surface.
    ASSERT_LT(sampledDistance(mesh, found, p), least + 0.02) << i;
  }
}

TEST(NearestTriangle, hasTheNearestCentreAmongTheTrianglesOfAVertex) {
  const TriangleMesh mesh = surfaces::inFloats(shapes::jittered(shapes::torus(20, 11), 0.05, 8));
  const CollapseMesh stars(mesh);
  const NearestTriangle nearest(mesh);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_EQ(nearest.find(mesh.positions[v], 0), nearest.findAround(v, stars.star(v)));
}

TEST(QemCost, pricesManyEdgesAtOnceBitByBitLikeOne) {
  for (const auto& [name, mesh] : surfaces::everyTopology()) {
    const CollapseMesh collapsing(mesh);
    QemCost costs(mesh, collapsing, {}, {.method = Method::Qem});
    std::vector<uint32_t> edges(collapsing.edgeCount());
    std::iota(edges.begin(), edges.end(), 0);
    costs.setBounds(edges);
    for (uint32_t edge : edges)
      ASSERT_EQ(costs.bound(edge), static_cast<float>(costs.optimum(edge).error))
          << name << ", edge " << edge;
  }
}

TEST(QemCost, putsTargetsWhereTheFileCanStoreThem) {
  TriangleMesh mesh = shapes::jittered(shapes::torus(12, 8), 0.03, 4);
  for (Vec3& p : mesh.positions) p += Vec3{100, -7, 0.3};
  mesh = surfaces::inFloats(mesh);
  const CollapseMesh collapsing(mesh);
  const QemCost costs(mesh, collapsing, {}, {.method = Method::Qem});
  for (uint32_t edge = 0; edge < collapsing.edgeCount(); ++edge) {
    const Vec3 target = costs.optimum(edge).position;
    EXPECT_EQ(collapsing.stored(target), target);
  }
}

}  // namespace
}  // namespace limber
