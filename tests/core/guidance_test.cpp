#include "fields/guidance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "elastic/modes.h"
#include "mesh/topology.h"
#include "shapes.h"

namespace limber {
namespace {

struct Analysed {
  TriangleMesh mesh;
  ModeSet modes;
  std::vector<double> omega;
};

Analysed analyse(const TriangleMesh& mesh, ElasticModel model = ElasticModel::Shell) {
  Job job;
  Analysed out{mesh, computeModes(mesh, {model, 4, unitMaterial(0.02)}, job), {}};
  out.omega.assign(out.modes.components.size() * out.modes.modesPerComponent, 0.0);
  for (const Mode& mode : out.modes.modes)
    out.omega[mode.component * out.modes.modesPerComponent + mode.ordinal] = mode.omega;
  return out;
}

StrainGuidance guide(const Analysed& body, const GuidanceOptions& options) {
  Job job;
  return strainGuidance(body.mesh, body.modes.shapes, body.omega, options, job);
}

TEST(Guidance, theFirstLaplacianModeOfTheBarStrainsItsMiddle) {
  const Analysed bar = analyse(shapes::box(4, 4, 12, 0.25), ElasticModel::Laplacian);
  const StrainGuidance guidance = guide(bar, {{0}, {}, 2, 0});
  double middle = 0, ends = 0;
  int middleCount = 0, endCount = 0;
  for (uint32_t t = 0; t < bar.mesh.triangleCount(); ++t) {
    const double z = (bar.mesh.corner(t, 0).z + bar.mesh.corner(t, 1).z + bar.mesh.corner(t, 2).z) / 3;
    if (z > 1 && z < 2) middle += guidance.rank[t], ++middleCount;
    if (z < 0.5 || z > 2.5) ends += guidance.rank[t], ++endCount;
  }
  EXPECT_GT(middle / middleCount, 0.65);
  EXPECT_LT(ends / endCount, 0.35);
}

TEST(Guidance, ranksFillTheUnitIntervalAndTheThresholdCutsThemOff) {
  const Analysed sheet = analyse(shapes::jittered(shapes::grid(6, 9), 0.01, 4));
  const auto ranks = guide(sheet, {{0, 1, 2}, {}, 2, 0}).rank;
  EXPECT_LT(*std::min_element(ranks.begin(), ranks.end()), 0.02);
  EXPECT_GT(*std::max_element(ranks.begin(), ranks.end()), 0.98);
  const auto cut = guide(sheet, {{0, 1, 2}, {}, 2, 0.6}).rank;
  for (size_t t = 0; t < ranks.size(); ++t) EXPECT_EQ(cut[t], ranks[t] < 0.6f ? 0 : ranks[t]);
}

TEST(Guidance, aPartsRanksDoNotDependOnOtherParts) {
  const TriangleMesh sheet = shapes::jittered(shapes::grid(5, 7), 0.01, 4);
  TriangleMesh ball = shapes::sphere(2, 0.3);
  for (Vec3& p : ball.positions) p.x += 4;
  const auto alone = guide(analyse(sheet), {{0, 1}, {}, 2, 0}).rank;
  const auto both = guide(analyse(shapes::together(sheet, ball)), {{0, 1}, {}, 2, 0}).rank;
  for (size_t t = 0; t < alone.size(); ++t) EXPECT_NEAR(both[t], alone[t], 0.02);
}

TEST(Guidance, weightsChooseBetweenModes) {
  const Analysed sheet = analyse(shapes::jittered(shapes::grid(6, 9), 0.01, 4));
  EXPECT_EQ(guide(sheet, {{0, 1}, {1, 0}, 2, 0}).rank, guide(sheet, {{0}, {1}, 2, 0}).rank);
  EXPECT_EQ(guide(sheet, {{0, 1}, {0, 1}, 2, 0}).rank, guide(sheet, {{1}, {1}, 2, 0}).rank);
}

TEST(Guidance, aModeThatWasNotComputedIsRefusedWithASentence) {
  const Analysed sheet = analyse(shapes::grid(4, 4));
  EXPECT_THROW(guide(sheet, {{4}, {}, 2, 0}), std::invalid_argument);
  EXPECT_THROW(guide(sheet, {{}, {}, 2, 0}), std::invalid_argument);
  EXPECT_THROW(guide(sheet, {{0}, {1, 2}, 2, 0}), std::invalid_argument);
  EXPECT_THROW(guide(sheet, {{0}, {}, 0.5, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace limber
