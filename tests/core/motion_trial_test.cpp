#include "fit/tune/motion_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "fit/tune/trial/implicit_motion.h"
#include "fit/tune/trial/swing_spectrum.h"
#include "fit/tune/trial/trial_scenes.h"
#include "shapes.h"

namespace limber {
namespace {

constexpr SolverModel kShell{StretchElement::Membrane, BendElement::HingeByArea},
    kSprings{StretchElement::EdgeSprings, BendElement::CrossSprings},
    kDihedral{StretchElement::EdgeSprings, BendElement::Hinge};
constexpr SolverConstants kConstants{
    .stretch = 4000, .secondStretch = 2000, .bend = 0.4, .surfaceDensity = 2, .unit = 1};

struct Body {
  TriangleMesh mesh;
  SolverConstants constants = kConstants;
  Pins pins = {};
  Topology topology = buildTopology(mesh);
  std::vector<double> masses = {}, factors = {};

  MovingBody moving() const { return {mesh, topology, constants, pins, masses, factors}; }
};

// A closed bar along z, of side 1 and length 3.
TriangleMesh bar(int cells) {
  return shapes::jittered(shapes::box(cells, cells, 3 * cells, 1.0 / cells), 1e-3, 1);
}

// A sheet in the plane of x and z, along x, so that it falls from its upper end.
TriangleMesh sheet(int cells) {
  TriangleMesh mesh = shapes::grid(2 * cells, cells, 2, 1);
  for (Vec3& p : mesh.positions) p = {p.x, 0.01 * std::sin(3 * p.x), p.y};
  return mesh;
}

TEST(MotionTrial, findsNoDeviationOfTheOriginalFromItself) {
  Job job;
  for (const SolverModel& model : {kShell, kSprings, kDihedral}) {
    const Body original{.mesh = bar(3)};
    MotionTrial trial(original.moving(), model, job);
    EXPECT_EQ(trial.refusal(), "");
    EXPECT_EQ(trial.scene(), "sway");
    const Body copy = original;
    EXPECT_LT(trial.deviationOf(copy.moving(), job).value(), 1e-3);
  }
}

TEST(MotionTrial, swaysByAFewPercentWhateverTheStiffnessTheMassAndTheUnit) {
  Job job;
  const WholePhase phase(job, Phase::Simulate);
  for (const double unit : {1e-3, 1.0, 40.0})
    for (const double stiffness : {1e-4, 1.0, 1e5}) {
      Body original{.mesh = bar(3)};
      for (double* constant : {&original.constants.stretch, &original.constants.secondStretch})
        *constant *= stiffness;
      original.constants.bend *= stiffness * unit * unit;
      original.constants.unit = unit;
      original.constants.surfaceDensity = 7;
      const auto scenes = trialScenes(original.moving(), kShell, job);
      ASSERT_EQ(scenes.size(), 1u);
      const TrialScene& scene = scenes[0];
      const SolverConstraints constraints(original.mesh, original.topology, kShell, original.constants);
      const std::vector<double> masses = massesOf(original.moving(), kShell);
      ImplicitMotion motion({constraints, original.mesh, masses, {}, scene.pins},
                            {scene.step, scene.motionSize, {}}, job);
      std::vector<Vec3> velocities;
      for (const Vec3& p : original.mesh.positions)
        velocities.push_back(scene.speed * initialVelocity(scene.scenario, p));
      motion.setVelocities(velocities);
      double most = 0;
      for (uint32_t i = 0; i < scene.stepCount; ++i) {
        ASSERT_TRUE(motion.step(job));
        for (uint32_t v = 0; v < original.mesh.vertexCount(); ++v)
          most = std::max(most, length(motion.positions()[v] - constraints.rest()[v]));
      }
      const double share = most / (bounds(original.mesh).diagonal() * unit);
      EXPECT_GT(share, 0.02);
      EXPECT_LT(share, 0.07);
    }
}

TEST(MotionTrial, seesAStiffnessThatIsOff) {
  Job job;
  const Body original{.mesh = bar(4)};
  Body coarse{.mesh = bar(2)};
  MotionTrial trial(original.moving(), kDihedral, job);
  const double plain = trial.deviationOf(coarse.moving(), job).value();
  coarse.constants.stretch *= 3;
  coarse.constants.bend *= 3;
  const double stiff = trial.deviationOf(coarse.moving(), job).value();
  EXPECT_GT(stiff, 1.2 * plain);
  Body softer{.mesh = original.mesh};
  softer.factors.assign(SolverConstraints(softer.mesh, softer.topology, kDihedral, softer.constants).count(),
                        0.5);
  const double soft = trial.deviationOf(softer.moving(), job).value();
  EXPECT_GT(soft, 0.5);
  EXPECT_LT(trial.noiseFloor(), 0.1 * soft);
}

TEST(MotionTrial, letsOpenSheetsHangAndPinnedBodiesDoBoth) {
  Job job;
  Body open{.mesh = sheet(5)};
  MotionTrial trial(open.moving(), kShell, job);
  EXPECT_EQ(trial.refusal(), "");
  EXPECT_EQ(trial.scene(), "hang");
  const Body other{.mesh = sheet(3)};
  const double deviation = trial.deviationOf(other.moving(), job).value();
  EXPECT_GT(deviation, 0.001);
  EXPECT_LT(deviation, 10);
  Body pinned{.mesh = bar(2)};
  pinned.pins.vertices = {0, 1, 2};
  EXPECT_EQ(MotionTrial(pinned.moving(), kShell, job).scene(), "sway and hang");
  EXPECT_EQ(MotionTrial(pinned.moving(), kShell, job).deviationsOf(pinned.moving(), job).value().size(), 2u);
}

TEST(MotionTrial, refusesWithASentence) {
  Job job;
  const Body large{.mesh = shapes::sphere(5)};
  MotionTrial trial(large.moving(), kShell, job);
  EXPECT_NE(trial.refusal().find("20480"), std::string::npos);
  EXPECT_FALSE(trial.deviationOf(large.moving(), job));
  EXPECT_EQ(trial.noiseFloor(), 0);
  EXPECT_NE(trial.refusal().find("20000"), std::string::npos);
  EXPECT_NE(MotionTrial(large.moving(), kSprings, job).refusal().find("10000"), std::string::npos);
}

TEST(MotionTrial, movesMorleysShellToo) {
  Job job;
  constexpr SolverModel morley{StretchElement::Membrane, BendElement::Morley};
  const Body original{.mesh = bar(4)}, coarse{.mesh = bar(3)};
  MotionTrial trial(original.moving(), morley, job);
  EXPECT_EQ(trial.refusal(), "");
  EXPECT_EQ(trial.deviationOf(original.moving(), job).value(), 0);
  const double plain = trial.deviationOf(coarse.moving(), job).value();
  Body stiff = coarse;
  stiff.constants.stretch *= 4;
  stiff.constants.secondStretch *= 4;
  stiff.constants.bend *= 4;
  EXPECT_GT(trial.deviationOf(stiff.moving(), job).value(), 1.5 * plain);
  EXPECT_LT(trial.noiseFloor(), plain);
}

TEST(MotionTrial, isTheSameOnAnyNumberOfThreads) {
  const auto deviation = [](int threads) {
    setThreadCount(threads);
    Job job;
    const Body original{.mesh = bar(3)}, coarse{.mesh = bar(2)};
    const double value =
        MotionTrial(original.moving(), kShell, job).deviationOf(coarse.moving(), job).value();
    setThreadCount(1);
    return value;
  };
  EXPECT_EQ(deviation(1), deviation(3));
}

// The apex of a triangle of springs whose other corners are pinned.
TEST(SwingSpectrum, findsTheFrequenciesOfABodyWithTheirShares) {
  TriangleMesh mesh;
  mesh.positions = {{-0.6, 0, 0}, {0.6, 0, 0}, {0, 0.8, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Topology topology = buildTopology(mesh);
  const SolverConstraints constraints(mesh, topology, kDihedral, kConstants);
  const std::vector<double> masses(3, 0.5);
  Job job;
  const WholePhase phase(job, Phase::Simulate);
  ImplicitSystem system({constraints, mesh, masses, {}, {{0, 1}, {}}}, 0, job);
  // Springs of length 1: along y 2 k 0.8^2 / m, along x 2 k 0.6^2 / m.
  const std::vector<SwingLine> lines = swingSpectrum(system, std::vector<Vec3>{{}, {}, {1, 2, 0}}, job);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_NEAR(lines[0].omegaSquared, 2 * 4000 * 0.36 / 0.5, 1e-3);
  EXPECT_NEAR(lines[1].omegaSquared, 2 * 4000 * 0.64 / 0.5, 1e-3);
  EXPECT_NEAR(lines[0].share, 0.2, 1e-9);
  EXPECT_NEAR(lines[1].share, 0.8, 1e-9);
  const Swing swing = swingOf(lines);
  EXPECT_NEAR(swing.omega, std::sqrt(2 * 4000 * 0.36 / 0.5), 1e-3);
  EXPECT_NEAR(swing.seconds * swing.seconds, 0.2 / lines[0].omegaSquared + 0.8 / lines[1].omegaSquared,
              1e-12);
}

}  // namespace
}  // namespace limber
