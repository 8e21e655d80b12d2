// Bodies on balls and capsules, with contacts anywhere on their triangles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <vector>

#include "base/parallel.h"
#include "moving_bodies.h"
#include "shapes.h"
#include "simulate/contacts/self_contacts.h"

namespace limber {
namespace {

using moving_bodies::kGravity;
using moving_bodies::run;

SimulationOptions leather(double thickness) {
  SimulationOptions options;
  options.material.young = 1e7;
  options.material.poisson = 0.3;
  options.material.density = 1000;
  options.material.thickness = thickness;
  options.substeps = 20;
  options.damping = 3;
  options.friction = 0.5;
  return options;
}

// A horizontal triangle around the y axis with edges of 2 m.
TriangleMesh largeTriangle(double height) {
  const double low = 1 / std::sqrt(3.0);
  return {{{-1, height, low}, {1, height, low}, {0, height, -2 * low}}, {{0, 1, 2}}};
}

TEST(SimulatedContacts, aLargeTriangleRestsOnASmallBallAndOnACapsuleWithoutSinkingIn) {
  for (const Vec3& axis : {Vec3{}, Vec3{1.5, 0, 0}, Vec3{0.4, 0, 1}}) {
    const TriangleMesh mesh = largeTriangle(0.22);
    Simulation body(mesh, leather(0.02));
    body.setGravity(kGravity);
    body.setColliders(std::vector<Collider>{{axis * -1.0, axis, 0.2}});
    run(body, 45);
    const double middle = body.position({0, {1.0 / 3, 1.0 / 3, 1.0 / 3}}).y;
    EXPECT_NEAR(middle, 0.2, 2e-3);
  }
}

TEST(SimulatedContacts, aTriangleThatHitsABallWithItsMiddleStopsWithoutSpin) {
  const TriangleMesh mesh = largeTriangle(0.4);
  SimulationOptions options = leather(0.02);
  options.damping = 0;
  Simulation body(mesh, options);
  body.setVelocities(std::vector<Vec3>(3, Vec3{0, -3, 0}));
  body.setColliders(std::vector<Collider>{{{}, {}, 0.2}});
  run(body, 20);
  for (uint32_t v = 0; v < 3; ++v) {
    EXPECT_NEAR(body.position(v).y, 0.2, 1e-3);
    EXPECT_LT(length(body.velocity(v)), 0.02);
  }
}

// A square sheet of 1 m that has come to rest on a ball: the distance of its nearest point from the ball's
// middle, and its mean height.
struct Rest {
  double nearest, mean;
};
Rest restOf(uint32_t cells) {
  TriangleMesh sheet = shapes::grid(cells, cells);
  for (Vec3& p : sheet.positions) p = {p.x - 0.5, 0.31, 0.5 - p.y};
  Simulation body(sheet, leather(0.01));
  body.setGravity(kGravity);
  body.setColliders(std::vector<Collider>{{{}, {}, 0.3}});
  run(body, 150);
  Rest rest = {1, 0};
  for (uint32_t t = 0; t < sheet.triangleCount(); ++t) {
    for (const uint32_t v : sheet.triangles[t]) rest.mean += triangleArea(sheet, t) * body.position(v).y / 3;
    for (int b = 0; b <= 12; ++b)
      for (int c = 0; b + c <= 12; ++c) {
        const Vec3 point = body.position({t, {(12 - b - c) / 12.0, b / 12.0, c / 12.0}});
        rest.nearest = std::min(rest.nearest, length(point));
      }
  }
  return rest;
}

TEST(SimulatedContacts, aCoarseAndAFineSheetComeToRestOnABallAtTheSameHeight) {
  const Rest coarse = restOf(5), fine = restOf(20);
  EXPECT_NEAR(coarse.nearest, 0.3, 1e-3);
  EXPECT_NEAR(fine.nearest, 0.3, 1e-3);
  EXPECT_NEAR(coarse.mean, fine.mean, 0.03 * 0.3);
}

// Within the first step it falls half its size.
TEST(SimulatedContacts, aSheetOfTwoMillimetresComesToRestOnTheFloor) {
  TriangleMesh mesh = shapes::grid(10, 10, 0.002, 0.002);
  for (Vec3& p : mesh.positions) p = {p.x, 0.0005, p.y};
  SimulationOptions options = leather(2e-5);
  Simulation body(mesh, options);
  body.setGravity(kGravity);
  body.setGround(0);
  for (int step = 0; step < 30; ++step) {
    run(body, 1);
    for (const Vec3& p : body.positions()) {
      EXPECT_GT(p.y, -2e-5) << step;
      EXPECT_LT(p.y, 0.0006) << step;
    }
  }
}

TEST(SelfContacts, takeMemoryInProportionToTheEdges) {
  constexpr uint32_t kSides = 30'000;
  TriangleMesh cone;
  cone.positions = {{0, 0, 0}, {0, 0, 1}};
  for (uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    cone.positions.push_back({std::cos(angle), std::sin(angle), 0.5});
    const uint32_t a = 2 + i, b = 2 + (i + 1) % kSides;
    cone.triangles.insert(cone.triangles.end(), {{0, b, a}, {1, a, b}});
  }
  // Lists of the vertices two edges away would take 3.6 GB.
  const SelfContacts contacts(cone, 0.3);
  EXPECT_EQ(contacts.count(), 0u);
}

// A sheet of cells of 1 m, and above its middle a sheet of as many cells of 1 cm.
TriangleMesh coarseAndFineSheet(int cells) {
  TriangleMesh mesh = shapes::grid(cells, cells, cells, cells);
  const TriangleMesh fine = shapes::grid(cells, cells, 0.01 * cells, 0.01 * cells);
  const uint32_t first = mesh.vertexCount();
  for (const Vec3& p : fine.positions) mesh.positions.push_back(p + Vec3{0.5 * cells, 0.5 * cells, 0.1});
  for (const Triangle& t : fine.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return mesh;
}

Particles particlesAt(const std::vector<Vec3>& positions) {
  Particles particles;
  particles.positions = positions;
  particles.inverseMass.assign(positions.size(), 1.0);
  particles.motion.assign(positions.size(), Motion{});
  return particles;
}

TEST(SelfContacts, ofAFinePartInACoarseBodyAreInProportionToItsVertices) {
  const TriangleMesh mesh = coarseAndFineSheet(50);
  SelfContacts contacts(mesh, 0.3);
  contacts.rebase(particlesAt(mesh.positions), 10);
  EXPECT_LT(contacts.count(), 8 * size_t{mesh.vertexCount()});
}

// The mean of the edges at a vertex, or three times the second shortest if that is less.
double ballAt(const TriangleMesh& mesh, uint32_t vertex) {
  std::vector<double> edges;
  for (const auto& edge : buildTopology(mesh).edges)
    if (edge.a == vertex || edge.b == vertex)
      edges.push_back(length(mesh.positions[edge.a] - mesh.positions[edge.b]));
  std::ranges::sort(edges);
  return std::min(std::accumulate(edges.begin(), edges.end(), 0.0) / static_cast<double>(edges.size()),
                  3 * edges[1]);
}

// A disc of needles around a small circle, which keeps opposite vertices of the rim more than two edges
// apart.
TriangleMesh needleDisc(uint32_t needles) {
  constexpr uint32_t kInner = 8;
  TriangleMesh mesh;
  const auto addCircle = [&](uint32_t count, double radius) {
    for (uint32_t i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      mesh.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
  };
  addCircle(kInner, 0.01);
  addCircle(needles, 1);
  for (uint32_t i = 0; i < needles; ++i) {
    const uint32_t a = kInner + i, b = kInner + (i + 1) % needles;
    const uint32_t near = i * kInner / needles, next = (i + 1) * kInner / needles;
    mesh.triangles.push_back({a, b, near});
    if (next != near) mesh.triangles.push_back({near, b, next % kInner});
  }
  return mesh;
}

TEST(SelfContacts, ofNeedlesAreInProportionToTheirNumber) {
  for (const uint32_t needles : {800u, 16'000u}) {
    const TriangleMesh mesh = needleDisc(needles);
    SelfContacts contacts(mesh, 0.3);
    contacts.rebase(particlesAt(mesh.positions), 10);
    EXPECT_LT(contacts.count(), 4 * size_t{needles}) << needles;
  }
}

// Two triangles of different size, each vertex of which is at rest 100 m away from the other triangle.
TEST(SelfContacts, keepVerticesApartByTheirEdges) {
  for (const double size : {1.0, 0.6, 0.03, 1e-4}) {
    TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1.2, 0}, {100, 0, 0}, {100 + size, 0, 0}, {100, size, 0}},
                         {{0, 1, 2}, {3, 4, 5}}};
    const double distance = (ballAt(mesh, 0) + ballAt(mesh, 3)) / 2;
    SelfContacts contacts(mesh, 0);
    for (const double near : {0.99, 0.5}) {
      Particles particles =
          particlesAt({{0, 0, 0}, {50, 0, 0}, {0, 50, 0}, {0, 0, near * distance}, {0, 0, 50}, {0, 70, 0}});
      contacts.rebase(particles, 10);
      ASSERT_EQ(contacts.count(), 1u) << size;
      contacts.project(particles);
      EXPECT_NEAR(double{particles.motion[3].q[2] - particles.motion[0].q[2]}, (1 - near) * distance,
                  1e-6 * distance);
    }
  }
}

// Folded in half, so that vertices of all sizes meet each other.
TEST(SelfContacts, areAllPairsThatAComparisonOfEachWithEachFinds) {
  constexpr int kCells = 14;
  TriangleMesh mesh = shapes::grid(kCells, kCells);
  for (Vec3& p : mesh.positions) p = {p.x * p.x * p.x, p.y, 0};
  std::vector<Vec3> folded = mesh.positions;
  for (Vec3& p : folded)
    if (p.y > 0.5) p = {p.x, 1.01 - p.y, 0.02};
  SelfContacts contacts(mesh, 0.3);
  contacts.rebase(particlesAt(folded), 10);

  std::vector<double> width;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) width.push_back(ballAt(mesh, v));
  std::vector<std::set<uint32_t>> ring(mesh.vertexCount());
  for (const Triangle& t : mesh.triangles)
    for (const uint32_t v : t) ring[v].insert(t.begin(), t.end());
  const auto areNear = [&](uint32_t a, uint32_t b) {
    return std::ranges::any_of(ring[a], [&](uint32_t v) { return ring[b].contains(v); });
  };
  size_t expected = 0;
  for (uint32_t b = 0; b < mesh.vertexCount(); ++b)
    for (uint32_t a = 0; a < b; ++a) {
      const double mean = (width[a] + width[b]) / 2, atRest = length(mesh.positions[a] - mesh.positions[b]);
      const bool meet = length(folded[a] - folded[b]) < std::min(mean, atRest) + 0.1 * mean;
      expected += meet && !areNear(a, b);
    }
  EXPECT_GT(expected, 500u);
  EXPECT_EQ(contacts.count(), expected);
}

TEST(SimulatedContacts, contactsOfTrianglesChangeNoBitWithTheNumberOfThreads) {
  const TriangleMesh mesh = shapes::box(16, 16, 64, 1.0 / 16);  // large enough for threads
  const Bounds box = bounds(mesh);
  const Vec3 under = {0.5 * (box.low.x + box.high.x), box.low.y - 0.05, box.low.z};
  const Collider capsule = {under, {under.x, under.y, box.high.z}, 0.1};
  std::vector<std::vector<Vec3>> runs;
  for (const int threads : {1, 2, 4}) {
    setThreadCount(threads);
    SimulationOptions options = leather(0.02);
    options.substeps = 4;
    Simulation body(mesh, options);
    body.setGravity(kGravity);
    body.setColliders(std::vector<Collider>{capsule});
    run(body, 3);
    runs.push_back(body.positions());
  }
  setThreadCount(1);
  EXPECT_TRUE(runs[0] == runs[1]);
  EXPECT_TRUE(runs[0] == runs[2]);
}

}  // namespace
}  // namespace limber
