#include "fit/tune/trial/area_barrier.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/tune/trial/implicit_motion.h"
#include "shapes.h"

namespace limber {
namespace {

// One triangle of height `height` above its base of length 1.
std::vector<Vec3> triangleOf(double height) {
  return {{-0.5, 0, 0}, {0.5, 0, 0}, {0, height, 0}};
}

constexpr std::array<std::array<uint32_t, 3>, 1> kTriangle = {{{0, 1, 2}}};
constexpr double kRestHeight = 0.8, kStiffness = 3;

AreaBarrier barrierOf(double height = kRestHeight) {
  return {kTriangle, triangleOf(height), kStiffness};
}

TEST(AreaBarrier, resistsOnlyWhereATriangleIsSmall) {
  const AreaBarrier barrier = barrierOf();
  ASSERT_EQ(barrier.count(), 1u);
  for (const double share : {2.0, 1.0, 0.7, 0.58}) {
    EXPECT_EQ(barrier.energyAt(triangleOf(share * kRestHeight)), 0);
    EXPECT_EQ(barrier.strainAt(0, triangleOf(share * kRestHeight)).strain.norm(), 0);
    EXPECT_FALSE(barrier.isActive(0, triangleOf(share * kRestHeight)));
  }
  // 1/2 k A0 ln(J0 / J)^2.
  for (const double share : {0.57, 0.3, 1e-3, 1e-9}) {
    const double logarithm = std::log(share * std::sqrt(3.0));
    const double energy = 0.5 * kStiffness * 0.5 * kRestHeight * logarithm * logarithm;
    EXPECT_NEAR(barrier.energyAt(triangleOf(share * kRestHeight)), energy, 1e-9 * energy);
    const ConstraintStrain at = barrier.strainAt(0, triangleOf(share * kRestHeight));
    EXPECT_NEAR(0.5 * at.strain.squaredNorm(), energy, 1e-9 * energy);
  }
  EXPECT_TRUE(std::isinf(barrier.energyAt(triangleOf(0))));
}

TEST(AreaBarrier, hasTheDerivativeOfItsEnergy) {
  const AreaBarrier barrier = barrierOf();
  std::vector<Vec3> x = {{-0.4, 0.03, 0.02}, {0.41, -0.05, 0.07}, {0.1, 0.2, -0.1}};
  const ConstraintStrain at = barrier.strainAt(0, x);
  ASSERT_GT(at.strain[0], 0);
  constexpr double step = 1e-6;
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const double before = x[k][axis];
      x[k][axis] = before + step;
      const double above = barrier.strainAt(0, x).strain[0];
      x[k][axis] = before - step;
      const double below = barrier.strainAt(0, x).strain[0];
      x[k][axis] = before;
      EXPECT_NEAR(at.jacobian(0, 3 * k + axis), (above - below) / (2 * step), 1e-7);
    }
}

TEST(AreaBarrier, leavesTrianglesWithoutAreaAlone) {
  EXPECT_EQ(barrierOf(0).count(), 0u);
  EXPECT_EQ(AreaBarrier(kTriangle, triangleOf(1), 0).count(), 0u);
  // Lowered by the same factor as the membrane of such a triangle.
  const double flat = barrierOf(1e-6).energyAt(triangleOf(1e-7)),
               same = barrierOf().energyAt(triangleOf(0.08));
  EXPECT_NEAR(flat / same, 1e-6 / 0.8 * 1e-2, 1e-4 * flat / same);
}

// A heavy corner above a pinned base: a St. Venant-Kirchhoff membrane lets it pass through.
TEST(AreaBarrier, stopsACornerThatFallsOnItsBase) {
  TriangleMesh mesh;
  mesh.positions = triangleOf(kRestHeight);
  mesh.triangles = {{0, 1, 2}};
  constexpr SolverModel model{StretchElement::Membrane, BendElement::HingeByArea};
  constexpr SolverConstants constants{
      .stretch = kStiffness, .secondStretch = 1, .bend = 0, .surfaceDensity = 2, .unit = 1};
  const Topology topology = buildTopology(mesh);
  const SolverConstraints constraints(mesh, topology, model, constants);
  const std::vector<double> masses = solverMasses(mesh, model.mass, constants);
  for (const double stiffness : {0.0, kStiffness}) {
    Job job;
    const WholePhase phase(job, Phase::Simulate);
    ImplicitMotion motion({constraints, mesh, masses, {}, {{0, 1}, {}}, stiffness},
                          {2e-3, kRestHeight, {0, -9.81, 0}}, job);
    double lowest = kRestHeight;
    for (int i = 0; i < 250; ++i) {
      ASSERT_TRUE(motion.step(job));
      lowest = std::min(lowest, motion.positions()[2].y);
    }
    if (stiffness > 0)
      EXPECT_GT(lowest, 0.01 * kRestHeight);
    else
      EXPECT_LT(lowest, -0.1 * kRestHeight);
  }
}

}  // namespace
}  // namespace limber
