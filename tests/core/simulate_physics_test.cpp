// The simulation compared with physics that any elastic body obeys.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "moving_bodies.h"
#include "shapes.h"
#include "simulate/running_scenario.h"
#include "simulate/scenario.h"
#include "simulate/wind.h"

namespace limber {
namespace {

using moving_bodies::kGravity;
using moving_bodies::rubber;
using moving_bodies::run;
using moving_bodies::struck;
using moving_bodies::volumeOf;

// A third of the triangles' mass at each vertex, as the simulation has it.
std::vector<double> massesOf(const TriangleMesh& mesh, double arealDensity) {
  std::vector<double> masses(mesh.vertexCount(), 0.0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) masses[v] += arealDensity * triangleArea(mesh, t) / 3;
  return masses;
}

struct Momentum {
  Vec3 linear, angular;
};
Momentum momentumOf(const Simulation& body, const std::vector<double>& masses) {
  Momentum sum;
  for (uint32_t v = 0; v < body.vertexCount(); ++v) {
    const Vec3 p = body.velocity(v) * masses[v];
    sum.linear += p;
    sum.angular += cross(body.position(v), p);
  }
  return sum;
}

TEST(SimulatedPhysics, aFreeBodyKeepsItsMomentumAndAngularMomentum) {
  for (const TriangleMesh& mesh : {shapes::torus(12, 8), shapes::grid(6, 4), shapes::box(2, 2, 4, 0.25)})
    for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell}) {
      Simulation body(mesh, rubber(0.02, 20, model));
      body.setVelocities(struck(mesh, 2));
      const auto masses = massesOf(mesh, 20);
      const Momentum before = momentumOf(body, masses);
      run(body, 60);
      const Momentum after = momentumOf(body, masses);
      EXPECT_TRUE(body.isFinite());
      const double scale = body.mass() * 2 * bounds(mesh).diagonal();
      EXPECT_LT(length(after.linear - before.linear) / scale, 1e-4);
      EXPECT_LT(length(after.angular - before.angular) / scale, 2e-3);
    }
}

TEST(SimulatedPhysics, energyNeverGrowsWithoutForces) {
  for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell}) {
    const TriangleMesh mesh = shapes::torus(12, 8);
    Simulation body(mesh, rubber(0.02, 100, model));
    body.setVelocities(struck(mesh, 1));
    const double start = body.kineticEnergy();
    for (int i = 0; i < 60; ++i) {
      run(body, 1);
      EXPECT_LT(body.kineticEnergy() + body.elasticEnergy(), 1.01 * start);
    }
  }
}

TEST(SimulatedPhysics, aBodyStruckHardReturnsToItsShape) {
  const TriangleMesh mesh = shapes::box(2, 2, 4, 0.25);
  SimulationOptions options = rubber(0.05, 50);
  options.damping = 6;
  Simulation body(mesh, options);
  body.setVelocities(struck(mesh, 3));
  run(body, 240);
  EXPECT_LT(body.elasticEnergy(), 1e-6 * body.mass());
  for (uint32_t v = 1; v < body.vertexCount(); ++v)
    EXPECT_NEAR(length(body.position(v) - body.position(0)), length(mesh.positions[v] - mesh.positions[0]),
                1e-3);
}

TEST(SimulatedPhysics, needlesDoNotTearABodyApart) {
  TriangleMesh mesh = shapes::torus(16, 8);
  for (uint32_t v = 0; v < mesh.vertexCount();
       v += 3) {  // almost onto a neighbour: a thousandth of the distance is left
    Vec3& p = mesh.positions[v];
    p += (mesh.positions[v + 1] - p) * 0.999;
  }
  for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell}) {
    Simulation body(mesh, rubber(0.05, 20, model));
    body.setVelocities(struck(mesh, 2));
    const double start = body.kineticEnergy();
    run(body, 60);
    ASSERT_TRUE(body.isFinite());
    EXPECT_LT(body.kineticEnergy(), start);
  }
}

TEST(SimulatedPhysics, aCantileverSagsAsBeamTheorySays) {
  // Length 1, width 0.25, thickness 0.2: stiff enough that the tip sinks by 3 % of the length.
  TriangleMesh flat = shapes::grid(13, 3, 1 + 1.0 / 12, 0.25);
  for (Vec3& p : flat.positions) p = {p.x, 0, p.y};
  Pins pins;
  for (uint32_t v = 0; v < flat.vertexCount(); ++v)
    if (flat.positions[v].x < 1.0 / 12 + 1e-9) pins.vertices.push_back(v);
  SimulationOptions options = rubber(0.2, 800);
  options.material.young = 1.2e7;
  options.material.poisson = 0;
  options.damping = 8;
  Simulation body(flat, options, pins);
  body.setGravity(kGravity);
  run(body, 150);
  const double load = 1000 * 0.2 * 9.81, rigidity = 1.2e7 * std::pow(0.2, 3) / 12;
  const double expected = load / (8 * rigidity);
  double sag = 0;
  for (uint32_t v = 0; v < flat.vertexCount(); ++v)
    if (flat.positions[v].x > 1.08) sag = std::max(sag, -body.position(v).y);
  EXPECT_NEAR(sag / expected, 1, 0.05);
}

TEST(SimulatedPhysics, aStiffPlateHungByAnEdgeSwingsAsAPendulum) {
  const TriangleMesh plate = shapes::grid(4, 8, 0.5, 1);
  Pins pins;
  for (uint32_t v = 0; v < plate.vertexCount(); ++v)
    if (plate.positions[v].y == 1) pins.vertices.push_back(v);
  SimulationOptions options = rubber(0.05, 100);
  options.material.young = 1e7;
  options.material.poisson = 0;
  Simulation body(plate, options, pins);
  body.setGravity(kGravity);
  std::vector<Vec3> push;
  for (const Vec3& p : plate.positions) push.push_back({0, 0, 0.1 * (1 - p.y)});
  body.setVelocities(push);
  // Lumped masses of the rows; the hinge row does not move.
  double moment = 0, inertia = 0;
  const auto masses = massesOf(plate, 50);
  for (uint32_t v = 0; v < plate.vertexCount(); ++v) {
    const double arm = 1 - plate.positions[v].y;
    moment += masses[v] * arm;
    inertia += masses[v] * arm * arm;
  }
  const double period = 2 * std::acos(-1.0) * std::sqrt(inertia / (moment * 9.81));
  const double steps = moving_bodies::periodOf(body, 240, [&] { return body.position(0).z; });
  EXPECT_NEAR(steps / 60 / period, 1, 0.01);
}

TEST(SimulatedPhysics, moreSubstepsConverge) {
  const TriangleMesh mesh = shapes::grid(6, 6);
  const auto tip = [&](int substeps) {
    Simulation body(mesh, rubber(0.03, substeps), {{0, 1, 2, 3, 4, 5, 6}, {}});
    body.setGravity(kGravity);
    run(body, 20);
    return body.position(mesh.vertexCount() - 1);
  };
  const Vec3 exact = tip(3200);
  const double coarse = length(tip(100) - exact), fine = length(tip(400) - exact);
  EXPECT_LT(fine, 0.5 * coarse);
}

TEST(SimulatedPhysics, anotherOrderOfTheConstraintsChangesTheMotionByLittle) {
  const TriangleMesh mesh = shapes::grid(8, 8);
  SimulationOptions options = rubber(0.03, 50);
  const Pins pins = {{0, 8}, {}};
  Simulation one(mesh, options, pins);
  options.order = 5;
  Simulation other(mesh, options, pins);
  for (Simulation* body : {&one, &other}) {
    body->setGravity(kGravity);
    run(*body, 30);
  }
  double largest = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    largest = std::max(largest, length(one.position(v) - other.position(v)));
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 0.02);
}

TEST(SimulatedPhysics, theNumberOfThreadsChangesNoBit) {
  const TriangleMesh mesh = shapes::box(32, 32, 96, 1.0 / 32);  // large enough for threads
  for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell}) {
    std::vector<std::vector<Vec3>> runs;
    for (const int threads : {1, 3}) {
      setThreadCount(threads);
      Simulation body(mesh, rubber(0.02, 3, model), {{0, 1, 2}, {}});
      body.setGravity(kGravity);
      run(body, 2);
      runs.push_back(body.positions());
    }
    setThreadCount(1);
    EXPECT_TRUE(runs[0] == runs[1]);
  }
}

TEST(SimulatedPhysics, aBallDroppedOnTheGroundComesToRestOnIt) {
  const TriangleMesh mesh = shapes::sphere(2, 0.2);
  SimulationOptions options = rubber(0.02, 50);
  options.damping = 2;
  Simulation body(mesh, options);
  body.setGravity(kGravity);
  body.setGround(-0.5);
  run(body, 240);
  double lowest = 1, middle = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    lowest = std::min(lowest, body.position(v).y);
    middle += body.position(v).y / mesh.vertexCount();
  }
  EXPECT_NEAR(lowest, -0.5, 1e-4);
  EXPECT_GT(middle, -0.4);
  EXPECT_LT(body.kineticEnergy(), 0.02);  // it may still roll, by centimetres a second
}

TEST(SimulatedPhysics, aDroppedBodyComesToRestOnTheGround) {
  for (const TriangleMesh& mesh : {shapes::box(3, 3, 9, 1.0 / 3), shapes::grid(8, 8)}) {
    const Scenario drop = {scenarioKind("drop"), bounds(mesh), 5};
    SimulationOptions options = rubber(0.02 * bounds(mesh).diagonal(), 20);
    options.damping = 4;
    Simulation body(mesh, options);
    startScenario(drop, mesh.positions, body);
    run(body, 300);
    const auto before = body.positions();
    run(body, 30);
    double moved = 0, lowest = 1e9;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      moved = std::max(moved, length(body.position(v) - before[v]));
      lowest = std::min(lowest, body.position(v).y);
    }
    EXPECT_LT(moved, 2e-4 * bounds(mesh).diagonal());
    EXPECT_NEAR(lowest, *collisionSceneOf(drop).ground, 1e-5);
  }
}

Scenario draping(const TriangleMesh& mesh) {
  const ScenarioKind* kind = scenarioKind("drape");
  return {kind, bounds(mesh), 5, 1, {}, startPose(kind, mesh)};
}

// A rotation by an angle about the direction (1, 2, 3).
TriangleMesh rotated(TriangleMesh mesh, double angle) {
  const Vec3 axis = normalized(Vec3{1, 2, 3});
  for (Vec3& p : mesh.positions)
    p = p * std::cos(angle) + cross(axis, p) * std::sin(angle) +
        axis * (dot(axis, p) * (1 - std::cos(angle)));
  return mesh;
}

TEST(SimulatedPhysics, clothIsDrapedFlatAboveTheBallAndTheFloorFromAnyPose) {
  for (const double angle : {0.0, 0.4, 1.1, 2.0, 3.1}) {
    TriangleMesh cloth = shapes::jittered(shapes::grid(12, 8, 1, 0.7), 0.01, 4);
    cloth = rotated(cloth, angle);
    const Scenario drape = draping(cloth);
    const TriangleMesh flat = posed(drape, cloth);
    const CollisionScene scene = collisionSceneOf(drape);
    const Collider& ball = scene.colliders.at(0);
    const Bounds box = bounds(flat);
    EXPECT_LT(box.high.y - box.low.y, 0.03);
    EXPECT_GT(box.low.y, ball.from.y + ball.radius);
    EXPECT_LT(box.low.y, ball.from.y + ball.radius + 0.03);
    EXPECT_DOUBLE_EQ(*scene.ground, ball.from.y - ball.radius);
    EXPECT_LT(std::abs(0.5 * (box.low.x + box.high.x) - ball.from.x), 1e-9);
    for (size_t v = 1; v < flat.positions.size(); ++v)  // a rotation, not a mirror image nor a deformation
      EXPECT_NEAR(length(flat.positions[v] - flat.positions[0]),
                  length(cloth.positions[v] - cloth.positions[0]), 1e-12);
    EXPECT_NEAR(dot(areaNormal(flat, 0),
                    cross(drape.pose->of(cloth.corner(0, 1)) - drape.pose->of(cloth.corner(0, 0)),
                          flat.corner(0, 2) - flat.corner(0, 0))),
                squaredLength(areaNormal(cloth, 0)), 1e-12);
  }
}

TEST(SimulatedPhysics, clothThatSlidesOffTheBallStaysOnTheFloor) {
  const TriangleMesh cloth = shapes::grid(14, 4, 1, 0.2);
  const Scenario drape = draping(cloth);
  SimulationOptions options = rubber(0.005, 20);
  options.friction = 0;
  Job job;
  RunningScenario body({cloth, options, {}}, drape, job);
  for (int i = 0; i < 240; ++i) body.step(job);
  const double ground = *collisionSceneOf(drape).ground;
  for (const Vec3& p : body.simulation().positions()) EXPECT_GT(p.y, ground - 1e-4);
}

TEST(SimulatedPhysics, clothComesToRestOnTheBallThatItIsDrapedOver) {
  const Scenario drape = draping(shapes::grid(12, 12));
  const TriangleMesh cloth = posed(drape, shapes::grid(12, 12));
  SimulationOptions options = rubber(0.01, 20);
  options.damping = 4;
  Simulation body(cloth, options);
  startScenario(drape, cloth.positions, body);
  run(body, 300);
  const Collider ball = collisionSceneOf(drape).colliders.at(0);
  double nearest = 1e9;
  for (uint32_t t = 0; t < cloth.triangleCount(); ++t) {
    nearest = std::min(nearest, length(body.position({t, {1.0 / 3, 1.0 / 3, 1.0 / 3}}) - ball.from));
    for (const uint32_t v : cloth.triangles[t]) {
      EXPECT_GT(length(body.position(v) - ball.from), ball.radius - 1e-4);
      EXPECT_LT(length(body.velocity(v)), 0.02);
    }
  }
  EXPECT_NEAR(nearest, ball.radius, 1e-3);
}

TEST(SimulatedPhysics, aTwistedClosedBodyKeepsItsVolume) {
  const TriangleMesh mesh = shapes::sphere(2, 0.5);
  const Scenario twist = {scenarioKind("twist"), bounds(mesh), 1};
  const Pins pins = {defaultPins(mesh, twist), {}};
  std::vector<Vec3> rest;
  for (const uint32_t v : pins.vertices) rest.push_back(mesh.positions[v]);
  Simulation body(mesh, rubber(0.02, 20), pins);
  const double volume = volumeOf(body.positions(), mesh);
  startScenario(twist, mesh.positions, body);
  for (int i = 0; i < 60; ++i) {
    prepareStep(twist, i * Simulation::kStep, rest, body);
    run(body, 1);
    EXPECT_NEAR(volumeOf(body.positions(), mesh) / volume, 1, 0.02);
  }
}

TEST(SimulatedPhysics, frictionStopsASlidingPlateAfterCoulombsDistance) {
  for (const double friction : {0.0, 0.5}) {
    TriangleMesh plate = shapes::grid(4, 4);
    for (Vec3& p : plate.positions) p = {p.x, 0, -p.y};
    SimulationOptions options = rubber(0.05, 20);
    options.friction = friction;
    Simulation body(plate, options);
    body.setGravity(kGravity);
    body.setGround(0);
    body.setVelocities(std::vector<Vec3>(plate.positions.size(), Vec3{2, 0, 0}));
    run(body, 60);
    // v^2 / (2 mu g), or v t.
    const double expected = friction > 0 ? 4 / (2 * friction * 9.81) : 2;
    EXPECT_NEAR((body.position(0).x - plate.positions[0].x) / expected, 1, 0.05);
  }
}

TEST(SimulatedPhysics, clothLiesOnBallsAndCapsulesAndNotInThem) {
  TriangleMesh cloth = shapes::grid(16, 16);
  for (Vec3& p : cloth.positions) p = {p.x - 0.5, 0.31, 0.5 - p.y};
  for (const Collider& collider :
       {Collider{{0, 0, 0}, {0, 0, 0}, 0.3}, Collider{{-1, 0, 0}, {1, 0, 0}, 0.3}}) {
    SimulationOptions options = rubber(0.01, 30);
    options.damping = 1;
    Simulation body(cloth, options);
    body.setGravity(kGravity);
    body.setColliders(std::vector<Collider>{collider});
    run(body, 60);
    double lowest = 1;
    for (uint32_t v = 0; v < cloth.vertexCount(); ++v) {
      const Vec3 p = body.position(v), radial = collider.to.x > 0 ? Vec3{0, p.y, p.z} : p;
      EXPECT_GT(length(radial), 0.3 - 1e-4);
      lowest = std::min(lowest, p.y);
    }
    EXPECT_LT(lowest, 0.1);
    EXPECT_GT(body.position(8 * 17 + 8).y, 0.29);
  }
}

// The smallest distance between two vertices that are at least `apart` edges' lengths from each other at
// rest.
double closest(const Simulation& body, const TriangleMesh& mesh, double apart) {
  double least = 1e9;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    for (uint32_t w = 0; w < v; ++w)
      if (length(mesh.positions[v] - mesh.positions[w]) > apart)
        least = std::min(least, length(body.position(v) - body.position(w)));
  return least;
}

TEST(SimulatedPhysics, aStripThatFoldsOnTheGroundLiesOnItselfOnlyWithSelfCollision) {
  TriangleMesh strip = shapes::grid(4, 40, 0.2, 2);  // upright, a little oblique
  for (Vec3& p : strip.positions) p = {p.x, p.y, 0.05 * p.y * p.y};
  for (const bool selfCollision : {false, true}) {
    SimulationOptions options = rubber(0.002, 30);
    options.damping = 1;
    options.selfCollision = selfCollision;
    Simulation body(strip, options);
    body.setGravity(kGravity);
    body.setGround(0);
    run(body, 90);
    EXPECT_TRUE(body.isFinite());
    if (selfCollision)
      EXPECT_GT(closest(body, strip, 0.15), 0.04);
    else
      EXPECT_LT(closest(body, strip, 0.15), 0.04);
  }
}

Vec3 middleOf(const Simulation& body, uint32_t begin, uint32_t end) {
  Vec3 sum;
  for (uint32_t v = begin; v < end; ++v) sum += body.position(v);
  return sum / (end - begin);
}

TEST(SimulatedPhysics, closedPartsThatAreDroppedOnEachOtherStayApart) {
  const TriangleMesh ball = shapes::sphere(2, 0.2);
  TriangleMesh upper = ball;
  for (Vec3& p : upper.positions) p = p + Vec3{0.02, 0.6, 0.01};
  const TriangleMesh both = shapes::together(ball, upper);
  const Scenario drop = {scenarioKind("drop"), bounds(both), 2};
  ASSERT_TRUE(touchesItself(drop, both));
  EXPECT_FALSE(touchesItself(drop, shapes::grid(3, 3)));
  EXPECT_FALSE(touchesItself({scenarioKind("sway"), bounds(both), 2}, both));
  Job job;
  RunningScenario body({both, rubber(0.02, 20), {}}, drop, job);
  const auto half = ball.vertexCount();
  double nearest = 1;
  for (int i = 0; i < 120; ++i) {
    body.step(job);
    const Simulation& now = body.simulation();
    nearest = std::min(nearest, length(middleOf(now, 0, half) - middleOf(now, half, 2 * half)));
  }
  EXPECT_LT(nearest, 0.5);  // they have met
  EXPECT_GT(nearest, 0.2);  // and neither middle has come into the other ball
}

TEST(SimulatedPhysics, aClosedBodyKeepsItsVolume) {
  const TriangleMesh mesh = shapes::sphere(2, 0.5);
  const auto volume = [&](bool keeps) {
    SimulationOptions options = rubber(0.005, 50);
    options.keepsVolume = keeps;
    options.damping = 2;
    Simulation body(mesh, options);
    body.setGravity(kGravity);
    body.setGround(-0.5);
    run(body, 60);
    return volumeOf(body.positions(), mesh);
  };
  const double rest = volumeOf(mesh.positions, mesh);
  EXPECT_NEAR(volume(true) / rest, 1, 0.01);
  EXPECT_LT(volume(false) / rest, 0.98);
}

TEST(SimulatedPhysics, windCarriesASheetAcrossItAndSlidesAlongItsPlane) {
  Simulation sheet(shapes::grid(4, 4), rubber(0.001, 20));
  sheet.setWind({0, 0, 5});
  run(sheet, 60);
  EXPECT_GT(sheet.position(12).z, 0.5);
  EXPECT_LT(sheet.velocity(12).z, 5);
  Simulation along(shapes::grid(4, 4), rubber(0.001, 20));
  along.setWind({5, 0, 0});
  run(along, 60);
  EXPECT_NEAR(along.position(12).x, 0.5, 1e-3);
}

// Over the windward half of a ball of radius r the pressure rho c / 2 (w . n)^2 adds up to rho c w^2 pi r^2
// / 4.
TEST(SimulatedPhysics, windPressesOnTheWindwardSideOfABallOnly) {
  const TriangleMesh ball = shapes::sphere(3, 0.5);
  const std::vector<double> masses = massesOf(ball, 20);
  const std::vector<Vec3> still(ball.positions.size());
  const Vec3 wind = {3, 0, 0};
  const auto accelerationOf = [&](bool closed) {
    return windAcceleration({ball.triangles, ball.positions, still, masses, closed}, wind, 1e-3);
  };
  const std::vector<Vec3> closed = accelerationOf(true), open = accelerationOf(false);
  double force = 0;
  uint32_t leeward = 0;
  for (uint32_t v = 0; v < ball.vertexCount(); ++v) {
    force += masses[v] * closed[v].x;
    if (ball.positions[v].x < 0.15) continue;
    ++leeward;
    EXPECT_EQ(length(closed[v]), 0);
    EXPECT_GT(length(open[v]), 0);
  }
  EXPECT_GT(leeward, ball.vertexCount() / 4);
  EXPECT_NEAR(force / (1.2 * 1.2 * 9 * std::acos(-1.0) * 0.25 / 4), 1, 0.02);
}

TEST(SimulatedPhysics, windCarriesABallAlong) {
  const TriangleMesh ball = shapes::sphere(2, 0.5);
  Simulation body(ball, rubber(0.001, 20));
  body.setWind({3, 0, 0});
  run(body, 30);
  Vec3 mean;
  for (uint32_t v = 0; v < ball.vertexCount(); ++v) mean += body.velocity(v) / ball.vertexCount();
  EXPECT_GT(mean.x, 0.1);
  EXPECT_LT(mean.x, 3);
  EXPECT_LT(std::hypot(mean.y, mean.z), 0.05 * mean.x);
}

TEST(SimulatedPhysics, aBodyHasDivergedBeyondTenTimesItsSizeAndNotByMovingAway) {
  const TriangleMesh mesh = shapes::grid(4, 4);
  Simulation thrown(mesh, rubber(0.02, 20));
  thrown.setVelocities(std::vector<Vec3>(mesh.positions.size(), Vec3{1e3, 0, 0}));
  run(thrown, 30);
  EXPECT_GT(thrown.position(0).x, 100 * bounds(mesh).diagonal());
  EXPECT_FALSE(thrown.hasDiverged());
  // Stretched by moving pins: all vertices are pinned, so the size is exact.
  Pins all;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) all.vertices.push_back(v);
  for (const double factor : {9.9, 10.1}) {
    Simulation body(mesh, rubber(0.02, 20), all);
    std::vector<Vec3> targets;
    for (const Vec3& p : mesh.positions) targets.push_back(p * factor);
    body.setPinTargets(targets);
    run(body, 1);
    EXPECT_EQ(body.hasDiverged(), factor > 10);
  }
  Simulation infinite(mesh, rubber(0.02, 20));
  infinite.setVelocities(std::vector<Vec3>(mesh.positions.size(), Vec3{INFINITY, 0, 0}));
  EXPECT_TRUE(infinite.hasDiverged());
}

TEST(SimulatedPhysics, componentsThatFallAwayFromEachOtherAreNoDivergence) {
  TriangleMesh hanging = shapes::box(1, 1, 1, 0.01), falling = hanging;
  for (Vec3& p : hanging.positions) p.y += 0.02;
  const TriangleMesh both = shapes::together(hanging, falling);
  for (const SimulationModel model : {SimulationModel::Shell, SimulationModel::Solid}) {
    Simulation body(both, rubber(0.001, 20, model), {{0, 1, 2, 3, 4, 5, 6, 7}});
    body.setGravity(kGravity);
    run(body, 60);
    EXPECT_LT(body.position(8).y, -100 * bounds(both).diagonal());
    EXPECT_FALSE(body.hasDiverged());
  }
}

TEST(SimulatedPhysics, pinnedPointsHoldAgainstAHandThatDragsBesideThem) {
  const TriangleMesh mesh = shapes::grid(4, 4);
  const Pins pins = {{}, {{0, {0.25, 0.25, 0.5}}, {31, {0.25, 0.25, 0.5}}}};
  Simulation body(mesh, rubber(0.02, 20), pins);
  const Vec3 rest = body.position(pins.points[0]);
  body.drag({0, {0.5, 0.25, 0.25}}, {0, 0, 0.3});
  run(body, 30);
  EXPECT_LT(length(body.position(pins.points[0]) - rest), 1e-3);
}

TEST(SimulatedPhysics, pinnedVerticesAndPinnedPointsGoToTheirTargets) {
  const TriangleMesh mesh = shapes::grid(6, 6);
  Pins pins = {{0, 6}, {{70, {0.25, 0.25, 0.5}}}};
  Simulation body(mesh, rubber(0.02, 20), pins);
  std::vector<Vec3> targets = {body.position(0), body.position(6), body.position(pins.points[0])};
  for (int i = 0; i < 30; ++i) {
    for (Vec3& target : targets) target += Vec3{0.01, 0, 0.02};
    body.setPinTargets(targets);
    run(body, 1);
  }
  EXPECT_LT(length(body.position(0) - targets[0]), 1e-9);
  EXPECT_LT(length(body.position(pins.points[0]) - targets[2]), 1e-4);
  EXPECT_THROW(body.setPinTargets(std::vector<Vec3>(2)), std::invalid_argument);
}

TEST(SimulatedPhysics, aDraggedPointReachesItsTargetAndFallsOnceReleased) {
  const TriangleMesh mesh = shapes::grid(6, 6);
  const SurfacePoint point = {30, {0.2, 0.3, 0.5}};
  SimulationOptions options = rubber(0.02, 20);
  options.damping = 2;
  Simulation body(mesh, options);
  const Vec3 target = body.position(point) + Vec3{0.3, 0.2, 0.5};
  for (int i = 0; i < 60; ++i) {
    body.drag(point, target);
    run(body, 1);
  }
  EXPECT_LT(length(body.position(point) - target), 1e-3);
  body.release();
  body.setGravity(kGravity);
  run(body, 30);
  EXPECT_GT(length(body.position(point) - target), 0.3);
}

TEST(SimulatedPhysics, theEndsOfATwistedBarArriveAtTheirTargets) {
  const TriangleMesh bar = shapes::box(4, 4, 12, 0.25);
  const Scenario twist = {scenarioKind("twist"), bounds(bar), 1};
  const Pins pins = {defaultPins(bar, twist), {}};
  ASSERT_EQ(pins.count(), 50u);
  Simulation body(bar, rubber(0.05, 50), pins);
  startScenario(twist, bar.positions, body);
  std::vector<Vec3> rest;
  for (const uint32_t v : pins.vertices) rest.push_back(bar.positions[v]);
  const Job job;
  for (int i = 0; i < 60; ++i) {
    prepareStep(twist, i * Simulation::kStep, rest, body);
    body.step(job);
  }
  EXPECT_TRUE(body.isFinite());
  for (size_t i = 0; i < rest.size(); ++i)
    EXPECT_LT(length(body.position(pins.vertices[i]) - pinTarget(twist, rest[i], 1)), 1e-9);
  // 45 degrees: the first corner of the top goes half its edge's length sideways times 2 sin(22.5).
  const Vec3 corner = {1, 1, 3}, rotated = pinTarget(twist, corner, 1);
  EXPECT_NEAR(length(rotated - corner), std::sqrt(0.5) * 2 * std::sin(std::acos(-1.0) / 8), 1e-12);
}

TEST(SimulatedPhysics, everyScenarioRunsOnABarAndOnASheet) {
  for (const TriangleMesh& mesh : {shapes::box(2, 2, 6, 0.5), shapes::grid(8, 6)})
    for (const SimulationModel model : {SimulationModel::Springs, SimulationModel::Shell})
      for (const std::string& name : scenarioNames()) {
        const Scenario scenario = {scenarioKind(name), bounds(mesh), 1};
        const Pins pins = {defaultPins(mesh, scenario), {}};
        std::vector<Vec3> rest;
        for (const uint32_t v : pins.vertices) rest.push_back(mesh.positions[v]);
        Simulation body(mesh, rubber(0.02 * bounds(mesh).diagonal(), 20, model), pins);
        startScenario(scenario, mesh.positions, body);
        const Job job;
        for (int i = 0; i < 60; ++i) {
          prepareStep(scenario, i * Simulation::kStep, rest, body);
          body.step(job);
        }
        EXPECT_TRUE(body.isFinite());
        double moved = 0;
        for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
          moved = std::max(moved, length(body.position(v) - mesh.positions[v]));
        EXPECT_GT(moved, 1e-3) << name;
        EXPECT_LT(moved, 3 * bounds(mesh).diagonal()) << name;
      }
}

TEST(SimulatedPhysics, aScenarioThatDoesNotExistIsRefusedWithTheNamesOfThoseThatDo) {
  try {
    scenarioKind("fall");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "There is no scenario \"fall\": take one of twist, sway, hang, drop, pull, wind, drape.");
  }
}

}  // namespace
}  // namespace limber
