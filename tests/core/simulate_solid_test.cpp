// Closed bodies that move as solids, compared with physics and the solid modes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "elastic/modes.h"
#include "moving_bodies.h"
#include "shapes.h"
#include "simulate/scenario.h"
#include "simulate/solid/lattice_body.h"
#include "simulate/solid/solid_state.h"

namespace limber {
namespace {

using moving_bodies::kGravity;
using moving_bodies::run;
using moving_bodies::struck;
using moving_bodies::volumeOf;

SimulationOptions rubber(int substeps, const Vec3& cellSize = {}) {
  SimulationOptions options = moving_bodies::rubber(0.01, substeps, SimulationModel::Solid);
  options.cellSize = cellSize;
  return options;
}

// Of rubber, kg/m3.
constexpr double kDensity = 1000;

double farthest(const Simulation& body, const TriangleMesh& mesh) {
  double most = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    most = std::max(most, length(body.position(v) - mesh.positions[v]));
  return most;
}

struct SolidMomentum {
  Vec3 linear, angular;
};
// Of all nodes.
SolidMomentum solidMomentum(const SolidState& body) {
  SolidMomentum sum;
  const Particles& particles = body.particles();
  for (uint32_t node = 0; node < particles.count(); ++node) {
    const Vec3 p = toVec3(particles.motion[node].q) / (body.substep() * particles.inverseMass[node]);
    sum.linear += p;
    sum.angular += cross(particles.positions[node], p);
  }
  return sum;
}

TEST(SimulatedSolid, aBodyAtRestStaysAtRest) {
  for (const TriangleMesh& mesh : {shapes::box(2, 2, 4, 0.25), shapes::torus(12, 8), shapes::sphere(2)}) {
    Simulation body(mesh, rubber(20));
    EXPECT_NEAR(body.mass(), kDensity * volumeOf(mesh.positions, mesh), 0.02 * body.mass());
    EXPECT_LT(farthest(body, mesh), 1e-9);
    run(body, 60);
    EXPECT_LT(farthest(body, mesh), 1e-6 * bounds(mesh).diagonal());
  }
}

std::vector<double> frequencyErrors(const TriangleMesh& mesh, int modeCount, int substeps) {
  Job job;
  const ModeSet set = computeModes(mesh, {ElasticModel::Solid, modeCount, rubber(substeps).material}, job);
  std::vector<double> errors;
  for (int k = 0; k < modeCount; ++k)
    errors.push_back(moving_bodies::frequencyError(
        mesh, set.modes[k], set.shapes.data() + size_t(k) * 3 * mesh.vertexCount(), rubber(substeps)));
  return errors;
}

TEST(SimulatedSolid, bodiesSwingWithTheFrequenciesOfTheSolidModes) {
  for (const TriangleMesh& mesh : {shapes::box(4, 4, 12, 0.25), shapes::sphere(3), shapes::torus(24, 12)})
    for (const double error : frequencyErrors(mesh, 4, 20)) EXPECT_LT(std::abs(error), 0.05);
}

// A wall of half a cell and a thinner strut, whose bending only depends on the hourglass stiffness of single
// cells.
TEST(SimulatedSolid, thinBodiesSwingWithTheFrequenciesOfTheSolidModes) {
  TriangleMesh plate = shapes::box(8, 1, 8, 0.25);
  for (Vec3& p : plate.positions) p.y *= 0.2;
  for (const double error : frequencyErrors(plate, 3, 40)) EXPECT_LT(std::abs(error), 0.05);
}

TEST(SimulatedSolid, theStiffnessOfEveryCellIsThatOfTheSolidModes) {
  // The energy of a small nonlinear deformation, compared with the quadratic form of the elements.
  const TriangleMesh mesh = shapes::torus(16, 10);
  Job job;
  const LatticeBody body = latticeBody(mesh, {0.1, 0.1, 0.1}, rubber(20).material, job);
  double least = 1;
  for (const CellRest& rest : body.rest) {
    const auto gradients = meanGradients(rest.size, rest.moments);
    Vec3 sum, moment;
    for (int k = 0; k < 8; ++k) {
      sum += gradients[k];
      for (int axis = 0; axis < 3; ++axis)
        moment[axis] += gradients[k][axis] * (k >> axis & 1) * rest.size[axis];
    }
    EXPECT_LT(length(sum), 1e-9 / rest.size.x);       // a translation has no gradient
    EXPECT_LT(length(moment - Vec3{1, 1, 1}), 1e-9);  // the gradient of the position is 1
    least = std::min(least, rest.volume / (rest.size.x * rest.size.y * rest.size.z));
    EXPECT_LT((rest.hourglass - rest.hourglass.transpose()).norm(), 1e-9 * rest.hourglass.norm());
  }
  EXPECT_LT(least, 0.2);
  double volume = 0, mass = 0;
  for (const CellRest& rest : body.rest) volume += rest.volume;
  for (const double m : body.masses) mass += m;
  EXPECT_NEAR(volume, volumeOf(mesh.positions, mesh), 0.01 * volume);
  EXPECT_NEAR(mass, kDensity * volumeOf(mesh.positions, mesh), 0.01 * mass);
}

TEST(SimulatedSolid, aFreeBodyFallsAsAPointAndKeepsItsShape) {
  const TriangleMesh mesh = shapes::torus(16, 10);
  Simulation body(mesh, rubber(20));
  body.setGravity(kGravity);
  run(body, 60);
  const int n = 60 * 20;
  const double fallen = -0.5 * 9.81 * (n + 1.0) / n;  // symplectic Euler
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    EXPECT_LT(length(body.position(v) - mesh.positions[v] - Vec3{0, fallen, 0}), 1e-4);
}

TEST(SimulatedSolid, aSpinningBodyKeepsSpinning) {
  const TriangleMesh mesh = shapes::box(2, 2, 6, 0.25);
  const Bounds box = bounds(mesh);
  const Vec3 middle = (box.low + box.high) * 0.5, spin = {0, 0, 4}, drift = {0.3, 0, 0.1};
  SimulationOptions options = rubber(100);  // XPBD takes (spin substep)^2 of the angular momentum per substep
  Simulation body(mesh, options);
  std::vector<Vec3> velocities;
  for (const Vec3& p : mesh.positions) velocities.push_back(cross(spin, p - middle) + drift);
  body.setVelocities(velocities);
  const double start = body.kineticEnergy();
  run(body, 120);
  EXPECT_NEAR(body.kineticEnergy() + body.elasticEnergy(), start, 0.02 * start);
  // After 2 s the body has rotated by 8 rad.
  const double angle = 8;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 arm = mesh.positions[v] - middle;
    const Vec3 expected = middle + drift * 2.0 +
                          Vec3{std::cos(angle) * arm.x - std::sin(angle) * arm.y,
                               std::sin(angle) * arm.x + std::cos(angle) * arm.y, arm.z};
    EXPECT_LT(length(body.position(v) - expected), 0.02 * box.diagonal());
  }
}

// The torques on the axes of cells are balanced by their mean strain, so struck bodies do not start to spin.
TEST(SimulatedSolid, aStruckBodyKeepsItsMomentumAndAngularMomentum) {
  const TriangleMesh mesh = shapes::torus(16, 10);
  Job job;
  SolidState body(mesh, rubber(40), {}, job);
  body.setVelocities(struck(mesh, 1));
  const SolidMomentum before = solidMomentum(body);
  const double scale = body.mass() * bounds(mesh).diagonal();
  for (int i = 0; i < 60; ++i) body.step(job, nullptr);
  const SolidMomentum after = solidMomentum(body);
  EXPECT_LT(length(after.linear - before.linear) / scale, 1e-4);
  EXPECT_LT(length(after.angular - before.angular) / scale, 2e-3);
}

TEST(SimulatedSolid, energyNeverGrowsWithoutForces) {
  for (const double young : {1e5, 1e7}) {
    const TriangleMesh mesh = shapes::torus(16, 10);
    SimulationOptions options = rubber(40);
    options.material.young = young;
    Simulation body(mesh, options);
    body.setVelocities(struck(mesh, 1));
    const double start = body.kineticEnergy();
    for (int i = 0; i < 60; ++i) {
      run(body, 1);
      EXPECT_LT(body.kineticEnergy() + body.elasticEnergy(), 1.02 * start);
    }
  }
}

TEST(SimulatedSolid, aStiffBodyWithFewSubstepsStaysWhole) {
  for (const double young : {1e8, 1e11})
    for (const int substeps : {1, 10}) {
      const TriangleMesh mesh = shapes::sphere(2);
      SimulationOptions options = rubber(substeps);
      options.material.young = young;
      Simulation body(mesh, options);
      body.setVelocities(struck(mesh, 1));
      const double start = body.kineticEnergy();
      run(body, 120);
      EXPECT_TRUE(body.isFinite());
      EXPECT_FALSE(body.hasDiverged());
      EXPECT_LT(body.kineticEnergy(), 1.05 * start);
    }
}

TEST(SimulatedSolid, aDroppedBodyKeepsItsVolumeAndLiesOnTheFloor) {
  const TriangleMesh mesh = shapes::box(4, 4, 4, 0.25);
  SimulationOptions options = rubber(20);
  options.damping = 3;
  Simulation body(mesh, options);
  body.setGravity(kGravity);
  body.setGround(-0.5);
  const double volume = volumeOf(mesh.positions, mesh);
  for (int i = 0; i < 300; ++i) {
    run(body, 1);
    EXPECT_NEAR(volumeOf(body.positions(), mesh), volume, 0.05 * volume);
  }
  double lowest = 1, fastest = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    lowest = std::min(lowest, body.position(v).y);
    fastest = std::max(fastest, length(body.velocity(v)));
  }
  EXPECT_NEAR(lowest, -0.5, 1e-3);
  EXPECT_LT(fastest, 0.01);
}

TEST(SimulatedSolid, aBodyLiesOnABallWithoutSinkingIn) {
  const TriangleMesh mesh = shapes::box(1, 1, 1, 1);  // all its vertices are corners
  SimulationOptions options = rubber(40);
  options.damping = 3;
  options.friction = 1;
  Simulation body(mesh, options);
  body.setGravity(kGravity);
  const Vec3 middle = {0.5, -0.35, 0.5};
  body.setColliders(std::vector<Collider>{{middle, middle, 0.3}});
  run(body, 120);
  Vec3 centre;
  for (const Vec3& p : body.positions()) centre += p * 0.125;
  EXPECT_GT(centre.y, 0.38);
  EXPECT_LT(centre.y, 0.5);
}

TEST(SimulatedSolid, pinsStayWhereTheyAre) {
  const TriangleMesh mesh = shapes::box(2, 2, 6, 0.25);
  const Scenario scenario = {scenarioKind("twist"), bounds(mesh), 1, 1, {}};
  Pins pins = {defaultPins(mesh, scenario)};
  ASSERT_EQ(pins.vertices.size(), 18u);
  std::reverse(pins.vertices.begin(), pins.vertices.end());
  Simulation body(mesh, rubber(20), pins);
  const Job job;
  std::vector<Vec3> rest, velocities;
  for (const uint32_t v : pins.vertices) rest.push_back(mesh.positions[v]);
  body.setGravity(kGravity);
  for (int i = 0; i < 60; ++i) {
    prepareStep(scenario, i * Simulation::kStep, rest, body);
    body.step(job);
    for (size_t pin = 0; pin < rest.size(); ++pin) {
      const Vec3 target = pinTarget(scenario, rest[pin], (i + 1) * Simulation::kStep);
      EXPECT_LT(length(body.position(pins.vertices[pin]) - target), 2e-3);
    }
  }
  EXPECT_GT(farthest(body, mesh), 0.1);
}

// How far a bar of 3 m hangs below its length, in units of rho g L^2 / (2 E), by which it stretches.
double hangingStretch(int substeps) {
  TriangleMesh mesh = shapes::box(2, 2, 12, 0.25);
  for (Vec3& p : mesh.positions) p = {p.x, -p.z, p.y};  // rotated about x: from y = 0 down to y = -3
  Pins pins;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (mesh.positions[v].y > -1e-9) pins.vertices.push_back(v);
  SimulationOptions options = rubber(substeps);
  options.material.young = 1e7;
  options.damping = 6;
  Simulation body(mesh, options, pins);
  body.setGravity(kGravity);
  run(body, 120);
  double lowest = 0;
  for (const Vec3& p : body.positions()) lowest = std::min(lowest, p.y);
  return (-lowest - 3) / (kDensity * 9.81 * 9 / (2 * 1e7));
}

// One pass over the constraints makes each of them softer by (w_a + w_b) substep^2, whatever the material:
// the error falls with the square of the substep, down to that of the lattice.
TEST(SimulatedSolid, aHangingBarStretchesByItsOwnWeight) {
  const double coarse = hangingStretch(20), fine = hangingStretch(40), finest = hangingStretch(80);
  EXPECT_NEAR((coarse - fine) / (fine - finest), 4, 0.5);
  EXPECT_NEAR(finest - (fine - finest) / 3, 1, 0.03);  // where infinitely many substeps would be
}

TEST(SimulatedSolid, aPointOfTheSurfaceCanBePinnedAndDragged) {
  const TriangleMesh mesh = shapes::sphere(2);
  const SurfacePoint point = {7, {0.2, 0.3, 0.5}};
  Simulation pinned(mesh, rubber(20), {{}, {point}});
  const Vec3 rest = pinned.position(point);
  pinned.setGravity(kGravity);
  run(pinned, 60);
  EXPECT_LT(length(pinned.position(point) - rest), 1e-3);
  Simulation dragged(mesh, rubber(20));
  const Vec3 target = {0, 3, 0};
  dragged.drag(point, target);
  run(dragged, 40);
  EXPECT_LT(length(dragged.position(point) - target), 0.05);
  dragged.release();
  EXPECT_THROW(dragged.drag({mesh.triangleCount(), {1, 0, 0}}, target), std::invalid_argument);
}

TEST(SimulatedSolid, pinsHoldAgainstAHandThatDragsBesideThem) {
  const TriangleMesh mesh = shapes::box(2, 2, 6, 0.25);
  const Pins pins = {defaultPins(mesh, {scenarioKind("sway"), bounds(mesh), 1, 1, {}})};
  ASSERT_EQ(pins.vertices.size(), 9u);
  Simulation body(mesh, rubber(20), pins);
  body.drag({0, {0.5, 0.25, 0.25}}, {0, 0, -1});
  run(body, 30);
  for (const uint32_t v : pins.vertices) EXPECT_LT(length(body.position(v) - mesh.positions[v]), 2e-3);
}

TEST(SimulatedSolid, aTwistedBodyComesBackWhenItIsReleased) {
  const TriangleMesh mesh = shapes::box(2, 2, 6, 0.25);
  SimulationOptions options = rubber(40);
  options.damping = 4;
  Simulation body(mesh, options);
  std::vector<Vec3> velocities;  // the upper end is struck so that it rotates by about a right angle
  for (const Vec3& p : mesh.positions)
    velocities.push_back(cross({0, 0, 40 * (p.z - 0.75)}, p - Vec3{0.25, 0.25, 0}));
  body.setVelocities(velocities);
  double most = 0;
  for (int i = 0; i < 300; ++i) {
    run(body, 1);
    most = std::max(most, body.elasticEnergy());
  }
  EXPECT_GT(most, 1e3 * body.elasticEnergy());
  for (uint32_t v = 1; v < mesh.vertexCount(); ++v)
    EXPECT_NEAR(length(body.position(v) - body.position(0)), length(mesh.positions[v] - mesh.positions[0]),
                5e-3);
}

// The cells are struck so hard that they are inside out after a substep.
TEST(SimulatedSolid, invertedCellsRecover) {
  const TriangleMesh mesh = shapes::box(2, 2, 2, 0.5);
  for (const double size : {1.0, 0.5}) {
    SimulationOptions options = rubber(20, {size, size, size});
    options.damping = 6;
    Simulation body(mesh, options);
    std::vector<Vec3> velocities;
    for (const Vec3& p : mesh.positions) velocities.push_back({0, 0, -1800 * (p.z - 0.5)});
    body.setVelocities(velocities);
    const double volume = volumeOf(mesh.positions, mesh);
    double least = volume;
    for (int i = 0; i < 300; ++i) {
      run(body, 1);
      least = std::min(least, volumeOf(body.positions(), mesh));
    }
    EXPECT_LT(least, 0);
    EXPECT_NEAR(volumeOf(body.positions(), mesh), volume, 0.01 * volume);
    for (uint32_t v = 1; v < mesh.vertexCount(); ++v)
      EXPECT_NEAR(length(body.position(v) - body.position(0)), length(mesh.positions[v] - mesh.positions[0]),
                  0.01);
  }
}

TEST(SimulatedSolid, windPushesABody) {
  const TriangleMesh mesh = shapes::sphere(2);
  Simulation body(mesh, rubber(10));
  body.setWind({20, 0, 0});
  run(body, 60);
  Vec3 moved;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    moved += (body.position(v) - mesh.positions[v]) / mesh.vertexCount();
  EXPECT_GT(moved.x, 0.01);
  EXPECT_LT(std::abs(moved.y) + std::abs(moved.z), 0.05 * moved.x);
}

TEST(SimulatedSolid, windDoesNothingToTrianglesWithoutArea) {
  // A tetrahedron whose edge along x is four triangles without area around vertex 6.
  const TriangleMesh mesh = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0, 0}, {0.5, 0, 0}, {0.375, 0, 0}},
      {{0, 3, 2},
       {1, 2, 3},
       {0, 4, 3},
       {4, 1, 3},
       {1, 5, 2},
       {5, 0, 2},
       {4, 0, 6},
       {1, 4, 6},
       {5, 1, 6},
       {0, 5, 6}}};
  Simulation body(mesh, rubber(10));
  body.setWind({20, 0, 0});
  run(body, 10);
  EXPECT_TRUE(body.isFinite());
  EXPECT_GT(body.position(0).x, mesh.positions[0].x);
}

std::vector<Vec3> positionsAfter(const TriangleMesh& mesh, const SimulationOptions& options, int threads) {
  const int before = threadCount();
  setThreadCount(threads);
  const Scenario scenario = {scenarioKind("drop"), bounds(mesh), 1, 1, {}};
  Simulation body(mesh, options);
  startScenario(scenario, mesh.positions, body);
  body.setVelocities(struck(mesh, 1));
  run(body, 30);
  setThreadCount(before);
  return body.positions();
}

TEST(SimulatedSolid, theResultDoesNotDependOnTheNumberOfThreads) {
  for (const TriangleMesh& mesh : {shapes::torus(24, 12), shapes::box(8, 8, 24, 0.125)}) {
    SimulationOptions options = rubber(10);
    ASSERT_GT(Simulation(mesh, options).constraintCount(), 1500u);
    const auto one = positionsAfter(mesh, options, 1), four = positionsAfter(mesh, options, 4);
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) EXPECT_EQ(one[v], four[v]);
    options.order = 1;
    const auto other = positionsAfter(mesh, options, 1);
    double most = 0;
    for (uint32_t v = 0; v < mesh.vertexCount(); ++v) most = std::max(most, length(other[v] - one[v]));
    EXPECT_GT(most, 0);
    EXPECT_LT(most, 1e-2 * bounds(mesh).diagonal());
  }
}

TEST(SimulatedSolid, closedComponentsAreSolidsAndOpenOnesShells) {
  const TriangleMesh ball = shapes::sphere(2), sheet = shapes::grid(6, 4);
  TriangleMesh both = shapes::together(sheet, ball);
  Pins pins = {{0, sheet.vertexCount()}, {{3, {1, 0, 0}}, {sheet.triangleCount() + 5, {0, 1, 0}}}};
  SimulationOptions options = rubber(20);
  Simulation body(both, options, pins);
  body.setGravity(kGravity);
  run(body, 30);
  Simulation ballAlone(ball, options, {{0}, {{5, {0, 1, 0}}}});
  options.model = SimulationModel::Shell;
  Simulation sheetAlone(sheet, options, {{0}, {{3, {1, 0, 0}}}});
  ballAlone.setGravity(kGravity);
  sheetAlone.setGravity(kGravity);
  run(ballAlone, 30);
  run(sheetAlone, 30);
  EXPECT_EQ(body.constraintCount(), ballAlone.constraintCount() + sheetAlone.constraintCount());
  EXPECT_DOUBLE_EQ(body.mass(), ballAlone.mass() + sheetAlone.mass());
  for (uint32_t v = 0; v < sheet.vertexCount(); ++v) EXPECT_EQ(body.position(v), sheetAlone.position(v));
  for (uint32_t v = 0; v < ball.vertexCount(); ++v)
    EXPECT_EQ(body.position(sheet.vertexCount() + v), ballAlone.position(v));
  EXPECT_EQ(squaredLength(solidCellSize(sheet)), 0);
  EXPECT_THROW(body.setPinTargets(std::vector<Vec3>(3)), std::invalid_argument);
}

TEST(SimulatedSolid, anOpenComponentWithoutAreaStaysWhereItIsBesideASolid) {
  const TriangleMesh ball = shapes::sphere(2), line = {{{0, 0, 2}, {0.5, 0, 2}, {1, 0, 2}}, {{0, 1, 2}}};
  const TriangleMesh both = shapes::together(ball, line);
  Simulation body(both, rubber(20)), alone(ball, rubber(20));
  body.setGravity(kGravity);
  alone.setGravity(kGravity);
  run(body, 10);
  run(alone, 10);
  for (uint32_t v = 0; v < ball.vertexCount(); ++v) EXPECT_EQ(body.position(v), alone.position(v));
  const SurfacePoint point = {ball.triangleCount(), {0.5, 0.5, 0}};
  EXPECT_EQ(body.position(ball.vertexCount() + 2), line.positions[2]);
  EXPECT_EQ(body.position(point), (Vec3{0.25, 0, 2}));
  EXPECT_EQ(body.velocity(ball.vertexCount()), Vec3{});
  EXPECT_NO_THROW(body.drag(point, {1, 1, 1}));
  EXPECT_THROW(Simulation(line, rubber(20)), std::invalid_argument);
}

TEST(SimulatedSolid, canBeCancelledWhileItsLatticeIsBuilt) {
  Job job;
  job.requestCancel();
  EXPECT_THROW(Simulation(shapes::sphere(2), rubber(20), {}, job), Cancelled);
}

TEST(SimulatedSolid, unitsDoNotMatter) {
  TriangleMesh inMetres = shapes::sphere(2), inMillimetres = inMetres;
  for (Vec3& p : inMillimetres.positions) p *= 1000;
  SimulationOptions options = rubber(20);
  Simulation metres(inMetres, options);
  options.material.unit = 0.001;
  Simulation millimetres(inMillimetres, options);
  metres.setVelocities(struck(inMetres, 1));
  millimetres.setVelocities(struck(inMetres, 1));
  run(metres, 20);
  run(millimetres, 20);
  EXPECT_NEAR(millimetres.mass(), metres.mass(), 1e-9 * metres.mass());
  for (uint32_t v = 0; v < inMetres.vertexCount(); ++v)
    EXPECT_LT(length(millimetres.position(v) / 1000 - metres.position(v)), 1e-3);
}

// Original and result get lattices of equally many cells along each axis.
TEST(SimulatedSolid, aCoarserMeshOfABodyMovesAlmostAlike) {
  const TriangleMesh fine = shapes::box(8, 8, 24, 0.125), coarse = shapes::box(2, 2, 6, 0.5);
  SimulationOptions options = rubber(20, solidCellSize(fine));
  Simulation a(fine, options), b(coarse, options);
  EXPECT_EQ(a.constraintCount(), b.constraintCount());
  const Scenario scenario = {scenarioKind("sway"), bounds(fine), 1, 1, {}};
  startScenario(scenario, fine.positions, a);
  startScenario(scenario, coarse.positions, b);
  run(a, 30);
  run(b, 30);
  for (uint32_t v = 0; v < coarse.vertexCount(); ++v)
    for (uint32_t w = 0; w < fine.vertexCount(); ++w) {
      if (length(coarse.positions[v] - fine.positions[w]) > 1e-9) continue;
      EXPECT_LT(length(a.position(w) - b.position(v)), 0.01 * bounds(fine).diagonal());
    }
}

}  // namespace
}  // namespace limber
