#include "fit/tune/trial/implicit_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "mesh/eigen_vec3.h"
#include "shapes.h"

namespace limber {
namespace {

constexpr SolverModel kShell{StretchElement::Membrane, BendElement::HingeByArea};
constexpr std::array kModels = {kShell, SolverModel{StretchElement::EdgeSprings, BendElement::Hinge},
                                SolverModel{StretchElement::EdgeSprings, BendElement::CrossSprings}};
constexpr SolverConstants kConstants{
    .stretch = 700, .secondStretch = 300, .bend = 0.3, .surfaceDensity = 2, .unit = 1};

// A mesh with its constraints and masses.
struct Body {
  TriangleMesh mesh;
  SolverModel model = kShell;
  SolverConstants constants = kConstants;
  Pins pins = {};
  Topology topology = buildTopology(mesh);
  SolverConstraints constraints{mesh, topology, model, constants};
  std::vector<double> masses = solverMasses(mesh, model.mass, constants);
  std::vector<double> factors = {};

  ConstrainedBody constrained() const { return {constraints, mesh, masses, factors, pins}; }
};

struct Motion {
  Job job;
  WholePhase phase{job, Phase::Simulate};
  ImplicitMotion motion;

  Motion(const Body& body, const ImplicitOptions& options) : motion(body.constrained(), options, job) {}
  void advance(int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(motion.step(job));
  }
};

// Two pinned vertices on a horizontal axis and one that swings about it at a distance of `length`.
Body pendulum(double length, double stretch) {
  TriangleMesh mesh;
  mesh.positions = {{-0.5, 0, 0}, {0.5, 0, 0}, {0, 0, length}};
  mesh.triangles = {{0, 1, 2}};
  SolverConstants constants = kConstants;
  constants.stretch = stretch;
  return {.mesh = mesh,
          .model = {StretchElement::EdgeSprings, BendElement::Hinge},
          .constants = constants,
          .pins = {{0, 1}, {}}};
}

TEST(ImplicitMotion, givesUpOnceTheMostWorkIsDone) {
  const Body body = pendulum(0.7, 1e7);
  const auto moves = [&](double mostWork) {
    Motion run(body, {.step = 0.05, .motionSize = 0.7, .gravity = {0, -9.81, 0}, .mostWork = mostWork});
    return run.motion.step(run.job);
  };
  EXPECT_TRUE(moves(1e6));
  EXPECT_FALSE(moves(0));
}

// Released at 90 degrees, its period is 2 pi sqrt(L / g) / agm(1, cos 45 degrees).
TEST(ImplicitMotion, swingsAPendulumWithItsPeriod) {
  constexpr double length = 0.7, gravity = 9.81;
  double a = 1, b = std::numbers::sqrt2 / 2;
  for (int i = 0; i < 8; ++i) std::tie(a, b) = std::pair((a + b) / 2, std::sqrt(a * b));
  const double period = 2 * std::numbers::pi * std::sqrt(length / gravity) / a;
  double former = 0;
  for (const int steps : {100, 200, 400}) {
    const Body body = pendulum(length, 1e7);
    Motion run(body, {period / steps, length, {0, -gravity, 0}});
    run.advance(steps);  // back at the height of the start
    const Vec3 at = run.motion.positions()[2];
    EXPECT_NEAR(std::hypot(at.y, at.z), length, 1e-4);
    const double error = std::abs(at.y);
    if (former > 0) {
      EXPECT_LT(error, former / 3);
    }
    former = error;
  }
  EXPECT_LT(former, 2e-3 * length);
}

TEST(ImplicitMotion, letsAFreeBodyFallWithoutStrain) {
  const Body body{.mesh = shapes::sphere(1)};
  Motion run(body, {0.01, 1, {0, -9.81, 0}});
  run.advance(50);
  for (size_t v = 0; v < body.mesh.positions.size(); ++v) {
    const Vec3 moved = run.motion.positions()[v] - body.mesh.positions[v];
    EXPECT_NEAR(moved.y, -0.5 * 9.81 * 0.25, 0.02 * 0.5 * 9.81 * 0.25);
    EXPECT_NEAR(moved.x, 0, 1e-10);
  }
  EXPECT_LT(run.motion.elasticEnergy(), 1e-18);
}

struct Mode {
  double omega;
  std::vector<Vec3> shape;
};

// An elastic mode of the free body by a dense eigenproblem of K = sum_c s_c J_c^T J_c.
Mode denseMode(const Body& body, int index) {
  const auto unknowns = 3 * static_cast<Eigen::Index>(body.masses.size());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(unknowns, unknowns), m = k;
  for (uint32_t c = 0; c < body.constraints.count(); ++c) {
    const SolverConstraint& constraint = body.constraints[c];
    Eigen::MatrixXd b = Eigen::MatrixXd::Zero(3, unknowns);
    const auto at = body.constraints.strainAt(c, body.constraints.rest());
    for (int i = 0; i < constraint.vertexCount; ++i)
      b.middleCols<3>(3 * static_cast<Eigen::Index>(constraint.vertices[i])) =
          at.jacobian.middleCols<3>(3 * i);
    k += (body.factors.empty() ? 1 : body.factors[c]) * b.transpose() * b;
  }
  for (Eigen::Index i = 0; i < unknowns; ++i) m(i, i) = body.masses[i / 3];
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(k, m);
  Mode mode{std::sqrt(solver.eigenvalues()[6 + index]), {}};
  const Eigen::VectorXd phi = solver.eigenvectors().col(6 + index);
  for (Eigen::Index i = 0; i < unknowns; i += 3) mode.shape.push_back({phi[i], phi[i + 1], phi[i + 2]});
  return mode;
}

// Started along a mode with a tiny velocity, the body returns to its start after each period. BDF2 delays the
// phase by 1/3 (omega h)^2.
TEST(ImplicitMotion, vibratesAtTheFrequenciesOfTheStiffnessMatrix) {
  for (const SolverModel& model : kModels) {
    Body body{.mesh = shapes::jittered(shapes::sphere(1), 0.1, 3), .model = model};
    for (uint32_t c = 0; c < body.constraints.count(); ++c) body.factors.push_back(0.5 + 0.1 * (c % 7));
    for (const int index : {0, 4}) {
      const Mode mode = denseMode(body, index);
      constexpr int steps = 240;
      const double step = 2 * std::numbers::pi / mode.omega / steps, amplitude = 1e-6;
      std::vector<Vec3> velocities;
      for (const Vec3& shape : mode.shape) velocities.push_back(shape * (amplitude * mode.omega));
      Motion run(body, {step, amplitude, {}});
      run.motion.setVelocities(velocities);
      // Along the mode, in amplitudes: sin(omega t).
      const auto along = [&] {
        double sum = 0;
        for (size_t v = 0; v < mode.shape.size(); ++v)
          sum += body.masses[v] * dot(mode.shape[v], run.motion.positions()[v] - body.mesh.positions[v]);
        return sum / amplitude;
      };
      run.advance(steps / 4);
      EXPECT_NEAR(along(), 1, 0.02);
      run.advance(steps / 4);
      EXPECT_NEAR(along(), 0, 0.02);
      run.advance(steps / 2);
      EXPECT_NEAR(along(), 0, 0.02);
    }
  }
}

// A bar that is pinned at one end and swings with a large amplitude.
Body bar(const SolverModel& model) {
  Body body{.mesh = shapes::box(2, 2, 6, 0.5), .model = model};
  body.constants.bend = 5;
  body.constraints = {body.mesh, body.topology, model, body.constants};
  for (uint32_t v = 0; v < body.mesh.vertexCount(); ++v)
    if (body.mesh.positions[v].z < 0.6) body.pins.vertices.push_back(v);
  return body;
}

std::vector<Vec3> blow(const Body& body) {
  std::vector<Vec3> velocities;
  for (const Vec3& p : body.mesh.positions) velocities.push_back({0.4 * p.z * p.z, 0, 0});
  return velocities;
}

double largestDifference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double most = 0;
  for (size_t v = 0; v < a.size(); ++v) most = std::max(most, length(a[v] - b[v]));
  return most;
}

TEST(ImplicitMotion, hasErrorsOfSecondOrderInLargeMotions) {
  for (const SolverModel& model : kModels) {
    const Body body = bar(model);
    std::vector<std::vector<Vec3>> ends;
    for (const int steps : {100, 200, 400}) {
      Motion run(body, {0.4 / steps, 0.1, {0, -9.81, 0}});
      run.motion.setVelocities(blow(body));
      run.advance(steps);
      ends.emplace_back(run.motion.positions().begin(), run.motion.positions().end());
    }
    EXPECT_GT(largestDifference(ends[2], body.mesh.positions), 0.1);
    const double first = largestDifference(ends[0], ends[1]), second = largestDifference(ends[1], ends[2]);
    EXPECT_LT(second, first / 2.5);
  }
}

TEST(ImplicitMotion, losesLittleEnergyAndLessWithSmallerSteps) {
  const Body body = bar(kModels[1]);
  std::vector<double> losses;
  for (const int steps : {150, 300, 600}) {
    Motion run(body, {0.6 / steps, 0.1, {0, -9.81, 0}});
    run.motion.setVelocities(blow(body));
    const auto energy = [&] {
      return run.motion.kineticEnergy() + run.motion.elasticEnergy() + run.motion.potentialEnergy();
    };
    const double before = energy();
    run.advance(steps);
    losses.push_back((before - energy()) / before);
    EXPECT_GT(losses.back(), 0);
  }
  EXPECT_LT(losses[1], 0.5 * losses[0]);
  EXPECT_LT(losses[2], 0.5 * losses[1]);
  EXPECT_LT(losses[2], 0.05);
}

TEST(ImplicitMotion, takesPinsToTheirTargets) {
  Body body = bar(kModels[0]);
  const uint32_t tip = body.mesh.triangleCount() - 1;
  body.pins.points = {{tip, {0.2, 0.5, 0.3}}};
  Motion run(body, {0.01, 0.1, {}});
  std::vector<Vec3> targets;
  for (const uint32_t v : body.pins.vertices) targets.push_back(body.mesh.positions[v]);
  Vec3 point;
  for (int c = 0; c < 3; ++c) point += body.mesh.corner(tip, c) * body.pins.points[0].barycentric[c];
  targets.push_back(point);
  for (int i = 0; i < 40; ++i) {
    targets.back() += Vec3{0.005, 0, 0};
    run.motion.setPinTargets(targets);
    run.advance(1);
    Vec3 at;
    for (int c = 0; c < 3; ++c)
      at += run.motion.positions()[body.mesh.triangles[tip][c]] * body.pins.points[0].barycentric[c];
    EXPECT_LT(length(at - targets.back()), 1e-4);
    EXPECT_EQ(length(run.motion.positions()[body.pins.vertices[0]] - targets[0]), 0);
  }
}

TEST(ImplicitMotion, doesNotDependOnTheNumberOfThreads) {
  const Body body{.mesh = shapes::sphere(3)};
  const auto ends = [&](int threads) {
    setThreadCount(threads);
    Motion run(body, {0.01, 0.1, {}});
    run.motion.setVelocities(blow(body));
    run.advance(6);
    setThreadCount(1);
    return std::vector<Vec3>(run.motion.positions().begin(), run.motion.positions().end());
  };
  EXPECT_EQ(ends(1), ends(3));
}

TEST(ImplicitMotion, stopsWhereItIsCancelled) {
  const Body body = bar(kModels[0]);
  Motion run(body, {0.01, 0.1, {0, -9.81, 0}});
  run.advance(1);
  run.job.requestCancel();
  EXPECT_THROW(run.motion.step(run.job), Cancelled);
}

}  // namespace
}  // namespace limber
