#include "compare/compare_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "shapes.h"
#include "simulate/running_scenario.h"
#include "transfer/carry_pins.h"

namespace limber {
namespace {

MotionOptions swaying(const TriangleMesh& mesh) {
  MotionOptions options;
  options.simulation.material.young = 1e6;
  options.simulation.material.poisson = 0.3;
  options.simulation.material.density = 1000;
  options.simulation.material.thickness = 0.02 * bounds(mesh).diagonal();
  options.simulation.substeps = 20;
  options.simulation.friction = 0.5;
  options.scenario = {scenarioKind("sway"), bounds(mesh), 0.5};
  options.pinned = defaultPins(mesh, options.scenario);
  options.sampleCount = 200;
  return options;
}

TEST(CompareMotion, aBodyMovesLikeItself) {
  const TriangleMesh mesh = shapes::grid(6, 12, 0.5, 1);
  Job job;
  const MotionComparison same = compareMotion(mesh, &mesh, swaying(mesh), job);
  EXPECT_EQ(same.deviation.mean, 0);
  EXPECT_EQ(same.deviation.max, 0);
  EXPECT_GT(same.noiseFloor, 0);
  EXPECT_LT(same.noiseFloor, 1);
  EXPECT_EQ(same.original.edges, same.other->edges);
}

TEST(CompareMotion, aFinerMeshOfTheSameSheetMovesAlmostAlike) {
  const TriangleMesh fine = shapes::grid(12, 24, 0.5, 1), coarse = shapes::grid(6, 12, 0.5, 1);
  MotionOptions options = swaying(fine);
  options.simulation.substeps = 60;
  Job job;
  const MotionComparison comparison = compareMotion(fine, &coarse, options, job);
  EXPECT_GT(comparison.deviation.mean, 0);
  EXPECT_LT(comparison.deviation.mean, 3);
  EXPECT_GT(comparison.original.constraints, 3 * comparison.other->constraints);
}

TEST(CompareMotion, recordsEveryStepOfEveryVertex) {
  const TriangleMesh mesh = shapes::grid(2, 4, 0.5, 1);
  MotionOptions options = swaying(mesh);
  options.records = true;
  Job job;
  const MotionComparison alone = compareMotion(mesh, nullptr, options, job);
  EXPECT_FALSE(alone.other.has_value());
  EXPECT_EQ(alone.original.positions.size(), 30 * 3 * mesh.positions.size());
  EXPECT_GT(alone.original.secondsPerStep, 0);
}

TEST(CompareMotion, stepsTwoBodiesTogetherAsItDoesOneByOne) {
  const TriangleMesh mesh = shapes::grid(6, 12, 0.5, 1);
  const MotionOptions options = swaying(mesh);
  const Pins pins = {options.pinned, {}};
  Job job;
  RunningScenario alone({mesh, options.simulation, pins}, options.scenario, job);
  RunningScenario one({mesh, options.simulation, pins}, options.scenario, job);
  RunningScenario two({mesh, options.simulation, pins}, options.scenario, job);
  RunningScenario* const both[] = {&one, &two};
  for (int i = 0; i < 10; ++i) {
    alone.step(job);
    stepTogether(both, job);
  }
  EXPECT_TRUE(alone.simulation().positions() == one.simulation().positions());
  EXPECT_TRUE(alone.simulation().positions() == two.simulation().positions());
}

// As on the page: both bodies step in parallel, and the deviation is measured after each step.
TEST(CompareMotion, steppingTwoBodiesSideBySideGivesTheSameDeviationToTheLastBit) {
  const TriangleMesh fine = shapes::grid(12, 24, 0.5, 1), coarse = shapes::grid(6, 12, 0.5, 1);
  const MotionOptions options = swaying(fine);
  Job job;
  const MotionComparison comparison = compareMotion(fine, &coarse, options, job);
  RunningScenario one({fine, options.simulation, {options.pinned, {}}}, options.scenario, job);
  const Pins carried = carryPins(fine, options.pinned, coarse);
  RunningScenario two({coarse, options.simulation, carried}, options.scenario, job);
  const MotionSamples onFine(fine, fine, one.simulation(), options.sampleCount);
  const MotionSamples onCoarse(fine, coarse, two.simulation(), options.sampleCount);
  RunningScenario* const both[] = {&one, &two};
  std::vector<Vec3> ofFine, ofCoarse;
  double worst = 0;
  for (int step = 0; step < 30; ++step) {
    stepTogether(both, job);
    const auto a = onFine.displacements(one.simulation()), b = onCoarse.displacements(two.simulation());
    worst = std::max(worst, motionDeviation(a, b, bounds(fine).diagonal()).max);
    ofFine.insert(ofFine.end(), a.begin(), a.end());
    ofCoarse.insert(ofCoarse.end(), b.begin(), b.end());
  }
  const MotionDeviation stepped = motionDeviation(ofFine, ofCoarse, bounds(fine).diagonal());
  EXPECT_GT(stepped.mean, 0);
  EXPECT_EQ(stepped.mean, comparison.deviation.mean);
  EXPECT_EQ(stepped.max, comparison.deviation.max);
  EXPECT_EQ(worst, comparison.deviation.max);
}

TEST(CompareMotion, tellsHowFarTheOriginalIsFromItselfWithTwiceTheSubsteps) {
  const TriangleMesh fine = shapes::grid(8, 16, 0.5, 1), coarse = shapes::grid(4, 8, 0.5, 1);
  MotionOptions options = swaying(fine);
  Job job;
  const MotionComparison at20 = compareMotion(fine, &coarse, options, job);
  options.simulation.substeps = 40;
  const MotionComparison at40 = compareMotion(fine, &coarse, options, job);
  EXPECT_EQ(at20.substeps, 20);
  EXPECT_GT(at20.substepDeviation, at40.substepDeviation);
  EXPECT_GT(at40.substepDeviation, 0);
  // The two runs that the first number compares, repeated.
  std::vector<std::vector<Vec3>> runs;
  for (const int substeps : {20, 40}) {
    options.simulation.substeps = substeps;
    RunningScenario body({fine, options.simulation, {options.pinned, {}}}, options.scenario, job);
    const MotionSamples samples(fine, fine, body.simulation(), options.sampleCount);
    runs.emplace_back();
    for (int step = 0; step < 30; ++step) {
      body.step(job);
      const auto moved = samples.displacements(body.simulation());
      runs.back().insert(runs.back().end(), moved.begin(), moved.end());
    }
  }
  EXPECT_EQ(at20.substepDeviation, motionDeviation(runs[0], runs[1], bounds(fine).diagonal()).mean);
}

TEST(CompareMotion, doublesTheSubstepsUntilTheOriginalHasConverged) {
  const TriangleMesh fine = shapes::grid(8, 16, 0.5, 1), coarse = shapes::grid(4, 8, 0.5, 1);
  MotionOptions options = swaying(fine);
  options.simulation.substeps = 5;
  Job job;
  const MotionComparison few = compareMotion(fine, &coarse, options, job);
  EXPECT_FALSE(few.isConverged);
  options.doublesSubsteps = true;
  const MotionComparison enough = compareMotion(fine, &coarse, options, job);
  EXPECT_TRUE(enough.isConverged);
  EXPECT_LE(enough.substepDeviation, kConverged * enough.deviation.mean);
  ASSERT_GT(enough.substeps, 5);
  // It equals the result with these substeps, and half of them are not enough.
  options.doublesSubsteps = false;
  options.simulation.substeps = enough.substeps;
  const MotionComparison again = compareMotion(fine, &coarse, options, job);
  EXPECT_EQ(again.deviation.mean, enough.deviation.mean);
  EXPECT_EQ(again.noiseFloor, enough.noiseFloor);
  options.simulation.substeps = enough.substeps / 2;
  EXPECT_FALSE(compareMotion(fine, &coarse, options, job).isConverged);
}

TEST(CompareMotion, aTunedSolverBringsTheOtherBodyBackToTheOriginal) {
  const TriangleMesh mesh = shapes::grid(8, 16, 0.5, 1);
  MotionOptions options = swaying(mesh);
  const SolverConstants stiff = {1000, 800, 0.05, 0.3, 1, 1};
  SolverConstants soft = stiff;
  for (double* constant : {&soft.stretch, &soft.secondStretch, &soft.bend}) *constant *= 0.5;
  const SolverModel model = {StretchElement::Membrane, BendElement::HingeByArea, MassRule::Area};
  options.simulation.solver = {model, stiff, {}, {}, {}};
  options.otherSolver = {model, soft, {}, {}, {}};
  Job job;
  EXPECT_GT(compareMotion(mesh, &mesh, options, job).deviation.mean, 0.1);
  const auto inner =
      static_cast<size_t>(3 * mesh.triangleCount() - 48) / 2;  // edges without 48 on the border
  options.otherSolver->stretchFactors.assign(mesh.triangleCount(), 2.0);
  options.otherSolver->bendFactors.assign(inner, 2.0);
  EXPECT_EQ(compareMotion(mesh, &mesh, options, job).deviation.mean, 0);
}

TEST(MotionDeviation, isThatOfDisplacementsInPercentOfTheDiagonal) {
  const std::vector<Vec3> still = {{0, 0, 0}, {0, 0, 0}}, moved = {{0.1, 0, 0}, {0, 0, 0.3}};
  const MotionDeviation deviation = motionDeviation(still, moved, 2);
  EXPECT_NEAR(deviation.mean, 10, 1e-12);
  EXPECT_NEAR(deviation.max, 15, 1e-12);
  EXPECT_EQ(motionDeviation(moved, moved, 2).max, 0);
}

TEST(MotionDeviation, bodiesThatRestApartAndMoveAlikeDoNotDeviate) {
  const TriangleMesh mesh = shapes::grid(4, 4);
  TriangleMesh apart = mesh;
  for (Vec3& p : apart.positions) p.z += 0.01;
  const SimulationOptions options = swaying(mesh).simulation;
  Simulation one(mesh, options), two(apart, options);
  const MotionSamples onOne(mesh, mesh, one), onTwo(mesh, apart, two);
  const Job job;
  for (Simulation* body : {&one, &two}) {
    body->setVelocities(std::vector<Vec3>(mesh.positions.size(), Vec3{1, 0, 0}));
    body->step(job);
  }
  EXPECT_LT(motionDeviation(onOne.displacements(one), onTwo.displacements(two), 1).max, 1e-4);
  EXPECT_NEAR(onOne.displacements(one)[0].x, 1.0 / 60, 1e-4);
}

TEST(CompareMotion, aMeshWithoutTrianglesIsRefusedWithASentence) {
  const TriangleMesh mesh = shapes::grid(6, 12, 0.5, 1);
  for (const SimulationModel model : {SimulationModel::Shell, SimulationModel::Solid}) {
    MotionOptions options = swaying(mesh);
    options.simulation.model = model;
    const TriangleMesh none;
    Job job;
    EXPECT_THROW(compareMotion(mesh, &none, options, job), std::invalid_argument);
  }
}

TEST(CompareMotion, aBodyThatDivergesIsRefusedWithASentence) {
  const TriangleMesh mesh = shapes::grid(6, 12, 0.5, 1);
  const MotionOptions options = swaying(mesh);
  Job job;
  RunningScenario body({mesh, options.simulation, {options.pinned, {}}}, options.scenario, job);
  EXPECT_NO_THROW(body.requireNotDiverged());
  body.simulation().drag({mesh.triangleCount() - 1, {0, 0, 1}}, {1e4, 0, 0});
  for (int step = 0; step < 30 && !body.simulation().hasDiverged(); ++step) body.step(job);
  EXPECT_TRUE(body.simulation().hasDiverged());
  EXPECT_THROW(body.requireNotDiverged(), std::runtime_error);
}

TEST(CompareMotion, aCancelledRunStops) {
  const TriangleMesh mesh = shapes::grid(6, 12, 0.5, 1);
  Job job;
  job.observer = [&](Phase, double fraction) {
    if (fraction > 0.3) job.requestCancel();
  };
  EXPECT_THROW(compareMotion(mesh, &mesh, swaying(mesh), job), Cancelled);
}

}  // namespace
}  // namespace limber
