#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mirrored.h"
#include "simplify/why_kept.h"
#include "surfaces.h"

namespace limber {
namespace {

struct Case {
  TriangleMesh mesh;
  std::vector<float> strain, curvature, keep;

  Guidance guidance() const { return {strain, curvature}; }
  SimplifyOptions options(Method method) const {
    return {.method = method,
            .strainWeight = method == Method::Limber ? 3 : 0.05,
            .curvatureWeight = 1,
            .qualityWeight = 0.1,
            .sizeWeight = 0.01,
            .constraints = {.keep = keep, .creaseAngle = 50}};
  }
};

Case makeCase() {
  Case it;
  it.mesh = surfaces::inFloats(shapes::jittered(shapes::box(6, 5, 9, 0.2), 0.02, 4));
  for (uint32_t t = 0; t < it.mesh.triangleCount(); ++t) it.strain.push_back(static_cast<float>(t % 11) / 11);
  for (uint32_t v = 0; v < it.mesh.vertexCount(); ++v) {
    it.curvature.push_back(static_cast<float>(v % 7) / 7);
    it.keep.push_back(static_cast<float>(v % 3) / 2);
  }
  return it;
}

// Before a collapse: the lowest legal cost at any vertex, and at the ends of the edge that collapses next.
struct NextCost {
  uint32_t collapse;
  double least, next;
};

// Every 37th collapse.
std::vector<NextCost> nextCosts(const Case& it, Method method) {
  Job job;
  const SimplifyOptions options = it.options(method);
  const History history = simplify(it.mesh, it.guidance(), options, job);
  std::vector<NextCost> all;
  for (uint32_t i = 0; i < history.collapseCount(); i += 37) {
    const uint32_t faces = i == 0 ? it.mesh.triangleCount() : history.trianglesAfter[i - 1];
    const MeshAt at = meshAt(it.mesh, history, faces);
    const auto why = whyKept({it.mesh, it.guidance(), options, history}, faces, job);
    EXPECT_EQ(why.size(), at.mesh.vertexCount());
    NextCost costs{i, INFINITY, INFINITY};
    const auto lower = [](double& cost, const WhyKept& of) {
      if (of.verdict == Verdict::Legal) cost = std::min(cost, of.terms.total());
    };
    for (const WhyKept& of : why) lower(costs.least, of);
    for (const uint32_t v : {history.kept[i], history.removed[i]})
      lower(costs.next, why[at.vertexOfInput[v]]);
    all.push_back(costs);
  }
  EXPECT_GT(all.size(), 3u);
  return all;
}

TEST(WhyKept, theVertexWithTheLowestLegalCostGoesNextWithPaper) {
  for (const auto& [collapse, least, next] : nextCosts(makeCase(), Method::Paper))
    EXPECT_EQ(static_cast<float>(next), static_cast<float>(least)) << "collapse " << collapse;
}

TEST(WhyKept, theVertexWithTheLowestLegalCostGoesFirstWithQem) {
  const NextCost first = nextCosts(makeCase(), Method::Qem)[0];
  EXPECT_EQ(static_cast<float>(first.next), static_cast<float>(first.least));
}

TEST(WhyKept, aVertexWithinEightPercentOfTheLowestLegalCostGoesFirstWithLimber) {
  const NextCost first = nextCosts(makeCase(), Method::Limber)[0];
  EXPECT_LE(first.next, 1.0801 * first.least);
}

// Neither method notices immediately that a cost has fallen.
TEST(WhyKept, noVertexOfFourTimesTheLowestLegalCostGoesNextWithQemAndLimber) {
  for (const Method method : {Method::Qem, Method::Limber})
    for (const auto& [collapse, least, next] : nextCosts(makeCase(), method))
      EXPECT_LE(next, 4 * least) << "collapse " << collapse;
}

TEST(WhyKept, namesTheRuleThatKeepsAVertexAtTheFloor) {
  const Case it = makeCase();
  Job job;
  const SimplifyOptions options = it.options(Method::Qem);
  const History history = simplify(it.mesh, it.guidance(), options, job);
  for (const WhyKept& why : whyKept({it.mesh, it.guidance(), options, history}, 0, job)) {
    EXPECT_NE(why.verdict, Verdict::Legal);
    EXPECT_NE(why.neighbour, kNone);
  }
}

TEST(WhyKept, asksTheMirrorToo) {
  for (const mirrored::Doubled& whole : {mirrored::sheet(), mirrored::box(), mirrored::ball(2, 1)}) {
    Job job;
    SimplifyOptions options{.method = Method::Qem, .qualityWeight = 0.1};
    options.constraints.mirror = whole.mirror;
    const History history = simplify(whole.mesh, {}, options, job);
    ASSERT_EQ(history.stop, StopReason::Exhausted);
    for (const WhyKept& why : whyKept({whole.mesh, {}, options, history}, 0, job))
      EXPECT_NE(why.verdict, Verdict::Legal);
  }
}

TEST(WhyKept, termsAreWhatTheirWeightsSay) {
  const Case it = makeCase();
  Job job;
  SimplifyOptions options = it.options(Method::Limber);
  const auto at = [&] {
    const History history = simplify(it.mesh, it.guidance(), options, job);
    return whyKept({it.mesh, it.guidance(), options, history}, it.mesh.triangleCount(), job);
  };
  for (const WhyKept& why : at()) {
    EXPECT_GE(why.terms.error, 0);
    EXPECT_GT(why.terms.size, 0);
    EXPECT_LE(why.terms.strain, 3.0001 * why.terms.size);
    EXPECT_GE(why.terms.quality, -1e-9 * why.terms.total());
    EXPECT_EQ(why.terms.curvature, 0);
    EXPECT_GE(why.terms.keep, 1);
  }
  options.strainWeight = options.qualityWeight = 0;
  for (const WhyKept& why : at()) {
    EXPECT_NEAR(why.terms.strain, 0, 1e-6 * why.terms.size);
    EXPECT_NEAR(why.terms.quality, 0, 1e-6 * why.terms.total());
  }
}

TEST(WhyKept, aHistoryOfAnotherMeshIsRefused) {
  const Case it = makeCase();
  Job job;
  History history = simplify(it.mesh, {}, {.method = Method::Qem}, job);
  std::ranges::reverse(history.kept);
  EXPECT_THROW(whyKept({it.mesh, {}, {.method = Method::Qem}, history}, 10, job), std::invalid_argument);
}

}  // namespace
}  // namespace limber
