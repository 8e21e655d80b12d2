#include "compare/compare_motion.h"

#include <gtest/gtest.h>

#include <vector>

#include "shapes.h"
#include "simulate/running_scenario.h"

namespace limber {
namespace {

MotionOptions swaying(const TriangleMesh& mesh) {
  MotionOptions options;
  options.simulation.young = 1e6;
  options.simulation.poisson = 0.3;
  options.simulation.density = 1000;
  options.simulation.thickness = 0.02 * bounds(mesh).diagonal();
  options.simulation.substeps = 20;
  options.scenario = {ScenarioKind::Sway, bounds(mesh), 0.5};
  options.pinned = defaultPins(mesh, options.scenario);
  options.sampleCount = 200;
  return options;
}

TEST(CompareMotion, aBodyMovesLikeItself) {
  const TriangleMesh mesh = shapes::grid(6, 12, 0.5, 1);
  Job job;
  const MotionComparison same = compareMotion(mesh, &mesh, swaying(mesh), job);
  EXPECT_EQ(same.deviationMean, 0);
  EXPECT_EQ(same.deviationMax, 0);
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
  EXPECT_GT(comparison.deviationMean, 0);
  EXPECT_LT(comparison.deviationMean, 3);
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
  RunningScenario alone(mesh, options.simulation, options.scenario, pins);
  RunningScenario one(mesh, options.simulation, options.scenario, pins);
  RunningScenario two(mesh, options.simulation, options.scenario, pins);
  RunningScenario* const both[] = {&one, &two};
  const Job job;
  for (int i = 0; i < 10; ++i) {
    alone.step(job);
    stepTogether(both, job);
  }
  EXPECT_TRUE(alone.simulation().positions() == one.simulation().positions());
  EXPECT_TRUE(alone.simulation().positions() == two.simulation().positions());
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
