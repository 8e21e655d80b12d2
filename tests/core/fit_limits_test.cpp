// A fit respects the limits that its result has been given: the largest deviation and the smallest angle.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "compare/surface_distance.h"
#include "fit/delaunay_flips.h"
#include "fit/modal_fit.h"
#include "fit/search/deviation_guard.h"
#include "fit/search/guarded_step.h"
#include "mesh/quality.h"
#include "shapes.h"
#include "simplify/simplify.h"
#include "surfaces.h"

namespace limber {
namespace {

Job theJob;

struct Case {
  TriangleMesh mesh;
  MeshAt start;
};

Case reduced(double minAngle = 0) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  SimplifyOptions options{.method = Method::Limber, .qualityWeight = 0.1, .sizeWeight = 0.01};
  options.minAngle = minAngle;
  return {mesh, meshAt(mesh, simplify(mesh, {}, options, theJob), mesh.triangleCount() / 4)};
}

ModalFitResult fit(const Case& of, double maxDeviation, double minAngle) {
  ModalFitOptions options{.thickness = 0.02 * bounds(of.mesh).diagonal(), .modeCount = 8};
  options.maxDeviation = maxDeviation;
  options.minAngle = minAngle;
  return fitModes(of.mesh, of.start, options, theJob);
}

double deviationOf(const Case& of, const TriangleMesh& result) {
  return measureSurfaceDistance(of.mesh, result, {}, theJob).hausdorff;
}

TEST(FitLimits, aFitKeepsTheLargestDeviation) {
  const Case of = reduced();
  const double before = deviationOf(of, of.start.mesh), limit = 1.15 * before;
  const ModalFitResult free = fit(of, 0, 0), limited = fit(of, limit, 0);
  ASSERT_GT(deviationOf(of, free.result.mesh), limit) << "otherwise the test shows nothing";
  EXPECT_LE(deviationOf(of, limited.result.mesh), limit);
  EXPECT_LT(limited.errorAfter.at(0), 0.8 * limited.errorBefore.at(0));
}

TEST(FitLimits, aFitKeepsTheSmallestAngle) {
  const Case of = reduced(25);
  const double before = measureQuality(of.start.mesh).minAngle;
  ASSERT_GT(before, 20);
  const ModalFitResult free = fit(of, 0, 0), limited = fit(of, 0, 25);
  ASSERT_LT(measureQuality(free.result.mesh).minAngle, before) << "otherwise the test shows nothing";
  EXPECT_GE(measureQuality(limited.result.mesh).minAngle, std::min(25.0, before));
  EXPECT_LT(limited.errorAfter.at(0), 0.8 * limited.errorBefore.at(0));
}

// The start violates both limits; the rest of the mesh is fitted.
TEST(FitLimits, aFitMakesNoViolationWorse) {
  const Case of = reduced();
  const double before = deviationOf(of, of.start.mesh), angle = measureQuality(of.start.mesh).minAngle;
  const ModalFitResult limited = fit(of, 0.8 * before, angle + 20);
  EXPECT_LE(deviationOf(of, limited.result.mesh), 1.02 * before);
  EXPECT_GE(measureQuality(limited.result.mesh).minAngle, angle - 1e-4);
  EXPECT_LT(limited.errorAfter.at(0), limited.errorBefore.at(0));
}

TEST(FitLimits, theFitIsTheSameOnAnyNumberOfThreads) {
  const Case of = reduced();
  const double limit = 1.1 * deviationOf(of, of.start.mesh);
  setThreadCount(1);
  const TriangleMesh one = fit(of, limit, 10).result.mesh;
  setThreadCount(3);
  EXPECT_EQ(fit(of, limit, 10).result.mesh.positions, one.positions);
  setThreadCount(1);
}

TEST(DeviationGuard, tellsWhichTrianglesHaveMovedTooFar) {
  const TriangleMesh fine = shapes::grid(16, 16), coarse = shapes::grid(4, 4);
  const ClosestPointTree tree(fine);
  DeviationGuard guard(fine, tree, 0.1);
  const std::vector<uint8_t> none(coarse.triangleCount(), 0);
  EXPECT_EQ(guard.begin(coarse), none);
  TriangleMesh moved = coarse;
  moved.positions[12].z = 0.08;  // the middle one
  EXPECT_EQ(guard.tooFar(moved), none);
  moved.positions[12].z = 0.12;
  const std::vector<uint8_t> far = guard.tooFar(moved);
  for (uint32_t t = 0; t < coarse.triangleCount(); ++t)
    EXPECT_EQ(far[t], std::ranges::count(coarse.triangles[t], 12u)) << t;
  // It may move any distance along the surface.
  moved.positions[12] = {0.6, 0.55, 0};
  EXPECT_EQ(guard.tooFar(moved), none);
}

TEST(DeviationGuard, measuresTheDistanceFromTheOriginalToo) {
  // A fine sheet with a spike, and a flat sheet: no point of the flat one is far from the fine one.
  TriangleMesh fine = shapes::grid(16, 16);
  const TriangleMesh coarse = shapes::grid(4, 4);
  const uint32_t spike = 17 * 6 + 5;
  fine.positions[spike].z = 0.3;
  const ClosestPointTree tree(fine);
  DeviationGuard guard(fine, tree, 0.1);
  const std::vector<uint8_t> far = guard.begin(coarse);
  EXPECT_EQ(std::accumulate(far.begin(), far.end(), 0), 1);
  // A triangle that was too far from the start is not reported again.
  EXPECT_EQ(guard.tooFar(coarse), std::vector<uint8_t>(coarse.triangleCount(), 0));
}

TEST(DeviationGuard, judgesAMeshThatHasMovedALittleAsANewGuardDoes) {
  const TriangleMesh fine = shapes::grid(40, 40), coarse = shapes::grid(10, 10);
  const ClosestPointTree tree(fine);
  DeviationGuard guard(fine, tree, 0.12), other(fine, tree, 0.12);
  guard.begin(coarse);
  TriangleMesh moved = coarse;
  moved.positions[60] = moved.positions[60] + Vec3{0.01, 0.02, 0.06};
  EXPECT_EQ(guard.begin(moved), other.begin(moved));
  for (const double z : {0.09, 0.1, 0.107, 0.109, 0.12, 0.2}) {
    moved.positions[60].z = z;
    EXPECT_EQ(guard.tooFar(moved), other.tooFar(moved)) << z;
  }
}

TEST(GuardedStep, doesNotMoveTrianglesThatAreTooFarAlready) {
  const TriangleMesh fine = shapes::grid(16, 16);
  TriangleMesh coarse = shapes::grid(4, 4);
  coarse.positions[12].z = 0.2;
  const ClosestPointTree tree(fine);
  DeviationGuard guard(fine, tree, 0.1);
  const GuardedStep step(coarse, {.deviation = &guard});
  const Eigen::VectorXd lift = Eigen::VectorXd::Constant(3 * coarse.vertexCount(), 0.01);
  const TriangleMesh moved = step.apply(coarse, lift);
  EXPECT_EQ(moved.positions[12], coarse.positions[12]);
  EXPECT_NE(moved.positions[0], coarse.positions[0]);
}

// A long quad that is cut along its longer diagonal; the ends of the shorter one are at a height.
TriangleMesh kite(double height) {
  return {{{-2, 0, 0}, {2, 0, 0}, {0, 1, height}, {0, -1, height}}, {{0, 1, 2}, {1, 0, 3}}};
}

uint32_t flipsOf(TriangleMesh mesh, const FlipLimits& limits) {
  std::vector<uint32_t> corners(3 * mesh.triangleCount());
  std::iota(corners.begin(), corners.end(), 0u);
  return flipToDelaunay(mesh, limits, corners);
}

TEST(DelaunayFlips, respectFixedEdgesLiftAndSmallestAngle) {
  EXPECT_EQ(flipsOf(kite(0), {}), 1u);
  const std::vector<std::array<uint32_t, 2>> fixed = {{0, 1}};
  EXPECT_EQ(flipsOf(kite(0), {.fixed = fixed}), 0u);
  // The distance between the diagonals is that height.
  EXPECT_EQ(flipsOf(kite(0.05), {.mostLift = 0.051}), 1u);
  EXPECT_EQ(flipsOf(kite(0.05), {.mostLift = 0.049}), 0u);
  // The new triangles have angles of 53 degrees.
  EXPECT_EQ(flipsOf(kite(0), {.minAngle = 53}), 1u);
  EXPECT_EQ(flipsOf(kite(0), {.minAngle = 54}), 0u);
}

}  // namespace
}  // namespace limber
