// Estimates of how far collapses move the surface.

#include "simplify/deviation_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/surface_distance.h"
#include "reduced.h"
#include "shapes.h"
#include "surfaces.h"

namespace limber {
namespace {

// A fan of eight triangles around an apex, vertex 0, above a flat outline of radius 1.
TriangleMesh fan(double height) {
  TriangleMesh mesh;
  mesh.positions.push_back({0, 0, height});
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({std::cos(i * std::numbers::pi / 4), std::sin(i * std::numbers::pi / 4), 0});
  for (uint32_t i = 0; i < 8; ++i) mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 8});
  return surfaces::inFloats(mesh);
}

// The collapse of vertex `removed` into its neighbour `kept`, which stays where it is.
Collapse collapseInto(const CollapseMesh& mesh, uint32_t kept, uint32_t removed) {
  for (uint32_t e = 0; e < mesh.edgeCount(); ++e) {
    const auto [a, b] = mesh.edge(e);
    if (std::minmax(a, b) == std::minmax(kept, removed)) return {e, kept, removed, mesh.position(kept)};
  }
  ADD_FAILURE() << "no such edge";
  return {};
}

TEST(DeviationEstimate, IsTheHeightOfAnApexThatIsTakenAway) {
  for (const double height : {0.0, 0.125, 0.5}) {
    const CollapseMesh mesh(fan(height));
    DeviationEstimate estimate(mesh);
    EXPECT_NEAR(estimate.of(collapseInto(mesh, 3, 0)), height, 1e-6);
  }
}

TEST(DeviationEstimate, CountsATargetThatLeavesTheSurface) {
  const CollapseMesh mesh(shapes::grid(4, 4));
  DeviationEstimate estimate(mesh);
  Collapse step = collapseInto(mesh, 12, 13);  // both within the sheet
  step.target = mesh.position(12) + Vec3{0, 0, 0.25};
  EXPECT_NEAR(estimate.of(step), 0.25, 1e-6);
}

TEST(DeviationEstimate, ForgetsWhatWasOnlyAskedFor) {
  CollapseMesh mesh(fan(0.5));
  DeviationEstimate estimate(mesh);
  const double asked = estimate.of(collapseInto(mesh, 3, 0));
  estimate.of(collapseInto(mesh, 5, 0));
  EXPECT_EQ(estimate.of(collapseInto(mesh, 3, 0)), asked);
  EXPECT_EQ(estimate.collapse(collapseInto(mesh, 3, 0)), asked);
}

TEST(DeviationEstimate, CostsNothingOnAFlatSheet) {
  Job job;
  const TriangleMesh sheet = surfaces::inFloats(shapes::grid(12, 9));
  const History history = simplify(sheet, {}, {.method = Method::Qem, .recordErrors = true}, job);
  ASSERT_EQ(history.errors.size(), history.trianglesAfter.size());
  ASSERT_LT(history.trianglesAfter.back(), 20u);
  for (size_t i = 0; history.trianglesAfter[i] >= 20; ++i)  // later ones cut corners
    EXPECT_LT(history.errors[i], 1e-6) << i;
}

// The guard measures a level where its estimate exceeds half of the limit, and trusts it below.
TEST(DeviationEstimate, IsAtLeastHalfOfTheMeasuredDeviation) {
  Job job;
  const TriangleMesh ball = surfaces::bumpySphere();
  for (const Method method : {Method::Qem, Method::Limber}) {
    const History history = simplify(ball, {}, {.method = method, .recordErrors = true}, job);
    for (const uint32_t part : {2u, 4u, 16u}) {
      const MeshAt level = meshAt(ball, history, ball.triangleCount() / part);
      const auto done = std::ranges::find_if(history.trianglesAfter,
                                             [&](uint32_t n) { return n <= level.mesh.triangleCount(); });
      const auto count = done - history.trianglesAfter.begin() + 1;
      const float most = *std::max_element(history.errors.begin(), history.errors.begin() + count);
      const double measured = measureSurfaceDistance(ball, level.mesh, {}, job).hausdorff;
      EXPECT_LE(measured, 2 * most) << "a " << part << "th of the faces";
      EXPECT_LE(most, 4 * measured) << "a " << part << "th of the faces";
    }
  }
}

}  // namespace
}  // namespace limber
