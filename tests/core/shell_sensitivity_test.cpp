#include "elastic/shell_sensitivity.h"

#include <gtest/gtest.h>

#include "elastic/shell.h"
#include "linear/eigensolver.h"
#include "shapes.h"

namespace limber {
namespace {

TEST(ShellSensitivity, isWhatMovingAVertexDoesToTheEigenvalue) {
  // Without symmetry all eigenvalues are simple. The grid is bent, so that membrane and bending both count.
  TriangleMesh mesh = shapes::jittered(shapes::grid(6, 4, 1, 0.7), 0.02, 3);
  for (Vec3& p : mesh.positions) p.z += 0.3 * p.x * p.x + 0.1 * p.y;
  const Topology topology = buildTopology(mesh);
  constexpr double kThickness = 0.03, kPoisson = 0.3;
  Job job;
  const auto solve = [&](const TriangleMesh& at) {
    return solveEigenproblem(shellPencil({at, topology, kThickness, kPoisson}), {6, 6, 0.05}, job).basis;
  };
  const ModeBasis basis = solve(mesh);
  for (int k = 0; k < 6; ++k) {
    const ModePair itself{k, k, basis.lambda[k]};
    const Eigen::VectorXd derivative =
        shellSensitivity({mesh, topology, kThickness, kPoisson}, basis.phi, {&itself, 1}, job);
    const double size = derivative.cwiseAbs().maxCoeff();
    for (uint32_t v : {0u, 9u, 17u, 30u})
      for (int axis = 0; axis < 3; ++axis) {
        const double step = 1e-5;
        TriangleMesh there = mesh, back = mesh;
        there.positions[v][axis] += step;
        back.positions[v][axis] -= step;
        const double difference = (solve(there).lambda[k] - solve(back).lambda[k]) / (2 * step);
        EXPECT_NEAR(derivative[3 * v + axis], difference, 1e-4 * size);
      }
  }
}

// A triangle flatter than kFlattestTriangle has the stiffness of one of that flatness.
TEST(ShellSensitivity, isTheDerivativeOfTheEnergyOfNeedlesToo) {
  constexpr double kThickness = 0.03, kPoisson = 0.3, kLambda = 2;
  Job job;
  for (const double height : {0.5, 1e-3, 5e-5, 1e-6}) {
    const TriangleMesh mesh = {{{0.1, 0, 0.2}, {0.9, 0.3, 0}, {0.4, 0.1125 + height, 0.125}}, {{0, 1, 2}}};
    const Topology topology = buildTopology(mesh);
    const Eigen::VectorXd psi = Eigen::VectorXd::LinSpaced(12, 0.3, 1).array().sin() *
                                Eigen::VectorXd::LinSpaced(12, 1, 9).array().cos();
    const auto energy = [&](const TriangleMesh& at) {
      const SparsePencil pencil = shellPencil({at, topology, kThickness, kPoisson});
      return psi.dot(pencil.k * psi) - kLambda * psi.dot(pencil.m.cwiseProduct(psi));
    };
    const ModePair itself{0, 0, kLambda};
    const Eigen::VectorXd derivative =
        shellSensitivity({mesh, topology, kThickness, kPoisson}, psi, {&itself, 1}, job);
    const double size = derivative.cwiseAbs().maxCoeff(), step = 1e-4 * height;
    for (uint32_t v = 0; v < 3; ++v)
      for (int axis = 0; axis < 3; ++axis) {
        TriangleMesh there = mesh, back = mesh;
        there.positions[v][axis] += step;
        back.positions[v][axis] -= step;
        const double difference = (energy(there) - energy(back)) / (2 * step);
        EXPECT_NEAR(derivative[3 * v + axis], difference, 1e-4 * size) << height;
      }
  }
}

TEST(ShellSensitivity, isZeroForRigidMotionsOfTheMesh) {
  const TriangleMesh mesh = shapes::jittered(shapes::sphere(1), 0.05, 4);
  const Topology topology = buildTopology(mesh);
  Job job;
  const ThinShell shell{mesh, topology, 0.05, 0.3};
  const ModeBasis basis = solveEigenproblem(shellPencil(shell), {3, 6, 0.05}, job).basis;
  const ModePair itself{0, 0, basis.lambda[0]};
  const Eigen::VectorXd derivative = shellSensitivity(shell, basis.phi, {&itself, 1}, job);
  double shift = 0, rotation = 0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    shift += derivative[3 * v];
    rotation += derivative[3 * v + 1] * mesh.positions[v].x - derivative[3 * v] * mesh.positions[v].y;
  }
  EXPECT_NEAR(shift, 0, 1e-7 * derivative.norm());
  EXPECT_NEAR(rotation, 0, 1e-7 * derivative.norm());
}

}  // namespace
}  // namespace limber
