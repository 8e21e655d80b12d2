#include "fit/shape_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/parallel.h"
#include "compare/surface_distance.h"
#include "fit/surface/border_corners.h"
#include "fit/surface/sheet_sizes.h"
#include "fit/surface/surface_fit.h"
#include "mesh/quality.h"
#include "mesh/repair/inspect.h"
#include "mirrored.h"
#include "shapes.h"
#include "simplify/simplify.h"
#include "surfaces.h"

namespace limber {
namespace {

Job theJob;

MeshAt simplified(const TriangleMesh& mesh, double ratio) {
  const SimplifyOptions options{.method = Method::Limber, .qualityWeight = 0.1, .sizeWeight = 0.01};
  const auto faces = static_cast<uint32_t>(ratio * mesh.triangleCount());
  return meshAt(mesh, simplify(mesh, {}, options, theJob), faces);
}

TriangleMesh fitted(const TriangleMesh& mesh, const MeshAt& start, const ShapeFitOptions& options = {}) {
  return fitShape(mesh, start, options, theJob).result.mesh;
}

// A grid with a wave across it whose outline is curved in space and, where `bulge` is not 0, in the plane.
TriangleMesh wavySheet(double bulge) {
  TriangleMesh mesh = shapes::grid(32, 26, 1, 0.8);
  for (Vec3& p : mesh.positions) {
    p.y += bulge * std::sin(std::numbers::pi * p.x);
    p.z = 0.06 * std::sin(5 * p.x) * std::cos(4 * p.y);
  }
  return surfaces::inFloats(mesh);
}

// A flat letter L of square cells, whose corner inside is reflex.
TriangleMesh letter() {
  TriangleMesh whole = shapes::grid(24, 24, 1, 1), mesh;
  std::vector<uint32_t> ids(whole.vertexCount(), kNone);
  for (const Triangle& triangle : whole.triangles) {
    const Vec3 sum =
        whole.positions[triangle[0]] + whole.positions[triangle[1]] + whole.positions[triangle[2]];
    if (sum.x > 1 && sum.y > 1) continue;
    Triangle own{};
    for (size_t c = 0; c < 3; ++c) {
      uint32_t& id = ids[triangle[c]];
      if (id == kNone) {
        id = mesh.vertexCount();
        mesh.positions.push_back(whole.positions[triangle[c]]);
      }
      own[c] = id;
    }
    mesh.triangles.push_back(own);
  }
  return surfaces::inFloats(mesh);
}

Eigen::Vector2d sizesOf(const TriangleMesh& mesh) {
  return measureSizes(mesh, buildTopology(mesh));
}

std::vector<Vec3> cornersOf(const TriangleMesh& mesh) {
  const std::vector<uint8_t> isCorner = findBorderCorners(mesh, buildTopology(mesh));
  std::vector<Vec3> corners;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (isCorner[v]) corners.push_back(mesh.positions[v]);
  return corners;
}

// The largest distance of a corner of `mesh` from the nearest corner of `result`, over the diagonal.
double cornerShift(const TriangleMesh& mesh, const TriangleMesh& result) {
  const std::vector<Vec3> there = cornersOf(result);
  double most = 0;
  for (const Vec3& corner : cornersOf(mesh)) {
    double least = HUGE_VAL;
    for (const Vec3& other : there) least = std::min(least, length(other - corner));
    most = std::max(most, least);
  }
  return most / bounds(mesh).diagonal();
}

double meanDistance(const TriangleMesh& mesh, const TriangleMesh& result) {
  return measureSurfaceDistance(mesh, result, {}, theJob).mean;
}

// Whether triangle t of the result is an unmoved triangle of the original.
bool isUnchanged(const TriangleMesh& original, const MeshAt& result, uint32_t t) {
  for (int c = 0; c < 3; ++c)
    if (!(result.mesh.corner(t, c) == original.corner(result.inputOfTriangle[t], c))) return false;
  return true;
}

TEST(ShapeFit, LeavesTrianglesOfTheOriginalAsTheyWere) {
  const TriangleMesh mesh = wavySheet(0.1);
  const MeshAt start = simplified(mesh, 0.8);
  const TriangleMesh result = fitted(mesh, start);
  const Topology after = buildTopology(result);
  uint32_t kept = 0, moved = 0;
  for (uint32_t v = 0; v < result.vertexCount(); ++v)
    moved += !(result.positions[v] == start.mesh.positions[v]);
  for (uint32_t t = 0; t < start.mesh.triangleCount(); ++t) {
    if (!isUnchanged(mesh, start, t)) continue;
    ++kept;
    const Triangle& corners = start.mesh.triangles[t];
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(result.positions[corners[c]], start.mesh.positions[corners[c]]) << t;
      EXPECT_NE(edgeBetween(after, corners[c], corners[(c + 1) % 3]), nullptr) << t;
    }
  }
  EXPECT_GT(kept, result.triangleCount() / 5);
  EXPECT_GT(moved, 0u);
}

TEST(SheetSizes, haveTheDerivativesOfFiniteDifferences) {
  TriangleMesh mesh = shapes::jittered(wavySheet(0.1), 0.004, 3);
  const Topology topology = buildTopology(mesh);
  const Eigen::MatrixX2d gradients = sizeGradients(mesh, topology);
  constexpr double kStep = 1e-6;
  for (uint32_t v = 0; v < mesh.vertexCount(); v += 5)
    for (int axis = 0; axis < 3; ++axis) {
      double& x = mesh.positions[v][axis];
      const double at = x;
      x = at + kStep;
      const Eigen::Vector2d more = measureSizes(mesh, topology);
      x = at - kStep;
      const Eigen::Vector2d less = measureSizes(mesh, topology);
      x = at;
      const Eigen::Vector2d slope = (more - less) / (2 * kStep);
      for (int k = 0; k < 2; ++k) EXPECT_NEAR(gradients(3 * v + axis, k), slope[k], 1e-7);
    }
}

TEST(BorderCorners, areThoseOfALetterAndOfNoRing) {
  const TriangleMesh mesh = letter();
  EXPECT_EQ(cornersOf(mesh).size(), 6u);
  EXPECT_TRUE(cornersOf(surfaces::annulus(40, 4)).empty());
  EXPECT_TRUE(cornersOf(shapes::sphere(2)).empty());
}

TEST(ShapeFit, keepsAreaOutlineAndCornersOfSheets) {
  for (const TriangleMesh& mesh : {wavySheet(0), wavySheet(0.2), letter()}) {
    const MeshAt start = simplified(mesh, 0.25);
    const TriangleMesh after = fitted(mesh, start);
    EXPECT_NE(after.positions, start.mesh.positions);
    const Eigen::Vector2d wanted = sizesOf(mesh), found = sizesOf(after);
    EXPECT_NEAR(found[0] / wanted[0], 1, 1e-3);
    EXPECT_NEAR(found[1] / wanted[1], 1, 2e-3);
    EXPECT_LT(cornerShift(mesh, after), 1e-3);
    EXPECT_EQ(after.triangleCount(), start.mesh.triangleCount());
  }
}

TEST(ShapeFit, givesASheetThatHasShrunkItsAreaAndItsOutlineBack) {
  const TriangleMesh mesh = surfaces::inFloats(surfaces::annulus(96, 16));
  MeshAt start = simplified(mesh, 0.25);
  for (Vec3& p : start.mesh.positions) p *= 0.996;
  const Eigen::Vector2d wanted = sizesOf(mesh), before = sizesOf(start.mesh),
                        after = sizesOf(fitted(mesh, start));
  for (int k = 0; k < 2; ++k) {
    EXPECT_LT(before[k] / wanted[k], 0.997);
    EXPECT_NEAR(after[k] / wanted[k], 1, 2e-4);
  }
}

TEST(ShapeFit, takesSmoothMeshesNearerAndMakesTheirTrianglesMoreEven) {
  for (const TriangleMesh& mesh : {wavySheet(0), surfaces::bumpySphere()}) {
    const MeshAt start = simplified(mesh, 0.25);
    const TriangleMesh after = fitted(mesh, start);
    EXPECT_LT(meanDistance(mesh, after), 0.95 * meanDistance(mesh, start.mesh));
    EXPECT_GT(measureQuality(after).meanMinAngle, measureQuality(start.mesh).meanMinAngle + 1);
    const Inspection was = inspect(start.mesh), is = inspect(after);
    EXPECT_EQ(is.components, was.components);
    EXPECT_EQ(is.boundaryLoops, was.boundaryLoops);
    EXPECT_EQ(is.genus, was.genus);
    EXPECT_EQ(is.nonManifoldEdges, 0u);
  }
}

TEST(ShapeFit, leavesTheAreaOfAClosedBodyAboutWhereTheCollapsesLeftIt) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  const MeshAt start = simplified(mesh, 0.25);
  const double wanted = sizesOf(mesh)[0];
  const double before = std::abs(sizesOf(start.mesh)[0] / wanted - 1);
  EXPECT_LT(std::abs(sizesOf(fitted(mesh, start))[0] / wanted - 1), before + 5e-4);
}

TEST(ShapeFit, keepsFlatSidesEdgesAndCornersOfABar) {
  const TriangleMesh mesh = shapes::box(8, 8, 24, 0.125);
  const MeshAt start = simplified(mesh, 0.25);
  const TriangleMesh after = fitted(mesh, start);
  EXPECT_NE(after.positions, start.mesh.positions);
  EXPECT_LT(measureSurfaceDistance(mesh, after, {}, theJob).hausdorff, 1e-5);
  EXPECT_NEAR(sizesOf(after)[0], sizesOf(mesh)[0], 1e-5);
}

// The corner of a box belongs to three planes; it must not become free if one of them has small triangles
// there.
TEST(ShapeFit, movesNoCornerOfACoarseBoxWhoseSidesAreCutUnevenly) {
  TriangleMesh mesh = shapes::box(12, 3, 3, 0.25);
  for (Vec3& p : mesh.positions) p.x = 3 * std::pow(p.x / 3, 3);
  mesh = surfaces::inFloats(mesh);
  const TriangleMesh after = fitted(mesh, simplified(mesh, 0.2));
  const Bounds box = bounds(mesh);
  for (const double x : {box.low.x, box.high.x})
    for (const double y : {box.low.y, box.high.y})
      for (const double z : {box.low.z, box.high.z})
        EXPECT_TRUE(std::ranges::any_of(after.positions,
                                        [&](const Vec3& p) { return length(p - Vec3{x, y, z}) < 1e-4; }));
}

TEST(ShapeFit, movesNoLockedAndNoPinnedVertex) {
  const TriangleMesh mesh = wavySheet(0);
  const MeshAt start = simplified(mesh, 0.25);
  std::vector<uint8_t> locked(mesh.vertexCount(), 0), pinned(mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < mesh.vertexCount(); v += 14)
    locked[v] = pinned[v + 7 < pinned.size() ? v + 7 : v] = 1;
  const TriangleMesh after =
      fitted(mesh, start, {.locked = locked, .pinned = PinnedVertices::fromMask(pinned)});
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (locked[v] || pinned[v]) {
      const uint32_t there = start.vertexOfInput[v];
      EXPECT_EQ(after.positions[there], start.mesh.positions[there]);
    }
  EXPECT_NE(after.positions, start.mesh.positions);
}

TEST(ShapeFit, tellsWhereTheCornersOfFlippedTrianglesComeFrom) {
  const TriangleMesh mesh = wavySheet(0);
  const ShapeFitResult fit = fitShape(mesh, simplified(mesh, 0.25), {}, theJob);
  EXPECT_GT(fit.flips, 0u);
  const auto& [triangles, corners] = fit.result.flips;
  for (uint32_t t = 0; t < fit.result.mesh.triangleCount(); ++t)
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t before = corners[3 * t + c];
      EXPECT_EQ(triangles[before / 3][before % 3], fit.result.mesh.triangles[t][c]);
    }
}

TEST(ShapeFit, keepsAMirrorSymmetry) {
  const mirrored::Doubled whole = mirrored::sheet();
  SimplifyOptions options{
      .method = Method::Limber, .qualityWeight = 0.02, .sizeWeight = 0.01, .stopFaces = 80};
  options.constraints.mirror = whole.mirror;
  const MeshAt start = meshAt(whole.mesh, simplify(whole.mesh, {}, options, theJob), 0);
  const TriangleMesh after = fitted(whole.mesh, start, {.mirror = whole.mirror});
  std::multiset<std::array<float, 3>> here, there;
  const auto asFloats = [](double x, const Vec3& p) {
    return std::array{static_cast<float>(x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  for (const Vec3& p : after.positions) {
    here.insert(asFloats(p.x == 0 ? 0 : p.x, p));
    there.insert(asFloats(p.x == 0 ? 0 : -p.x, p));
  }
  EXPECT_EQ(here, there);
  EXPECT_NE(after.positions, start.mesh.positions);
}

TEST(ShapeFit, keepsItsLimits) {
  const TriangleMesh mesh = surfaces::bumpySphere();
  const MeshAt start = simplified(mesh, 0.25);
  const double deviation = measureSurfaceDistance(mesh, start.mesh, {}, theJob).hausdorff;
  const double angle = measureQuality(start.mesh).minAngle;
  const TriangleMesh after = fitted(mesh, start, {.maxDeviation = deviation, .minAngle = angle});
  EXPECT_LE(measureSurfaceDistance(mesh, after, {}, theJob).hausdorff, 1.001 * deviation);
  EXPECT_GE(measureQuality(after).minAngle, angle - 1e-3);
}

TEST(ShapeFit, isTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = wavySheet(0.1);
  const MeshAt start = simplified(mesh, 0.25);
  const int before = threadCount();
  setThreadCount(1);
  const TriangleMesh one = fitted(mesh, start);
  setThreadCount(3);
  EXPECT_EQ(fitted(mesh, start).positions, one.positions);
  setThreadCount(before);
}

TEST(ShapeFit, doesNothingToAWholeMeshAndCanBeCancelled) {
  const TriangleMesh mesh = wavySheet(0);
  EXPECT_EQ(fitted(mesh, simplified(mesh, 1)).positions, mesh.positions);
  Job job;
  const MeshAt start = simplified(mesh, 0.25);
  job.requestCancel();
  EXPECT_THROW(fitShape(mesh, start, {}, job), Cancelled);
}

// Otherwise the few points of a large flat side, far from its corners, would leave these free to move.
TEST(FitSamples, areAsDenseOnLargeTrianglesAsOnTheMean) {
  TriangleMesh mesh = shapes::grid(10, 10);  // 200 triangles
  const auto first = mesh.vertexCount();
  for (const Vec3& p : {Vec3{2, 0, 0}, {3, 0, 0}, {2, 2, 0}}) mesh.positions.push_back(p);
  mesh.triangles.push_back({first, first + 1, first + 2});  // as large as all others
  const FitSamples samples = sampleForFit(mesh, buildTopology(mesh), 201, {});
  const auto isOnLarge = [](const FitSamples::OnSurface& sample) { return sample.point.x > 1.5; };
  const auto large = std::ranges::count_if(samples.surface, isOnLarge);
  EXPECT_EQ(samples.surface.size() - static_cast<size_t>(large), 200U);
  EXPECT_GT(large, 70);  // of the 100.5 that are in proportion, as many as n^2 parts allow
  EXPECT_LE(large, 100);
  double area = 0;
  for (const auto& sample : samples.surface) area += sample.area;
  EXPECT_NEAR(area, 2, 1e-12);
}

// Triangles that are closest to no sample of the original, here because a plate twice as fine lies on them,
// would be unconstrained.
TEST(SurfaceFit, keepsThePlanesOfTrianglesThatNoSampleFinds) {
  TriangleMesh mesh = shapes::grid(2, 2);
  const Topology topology = buildTopology(mesh);
  FitSamples samples;
  samples.surface.push_back({{0.1, 0.05, 0}, {0, 0, 1}, 0.5});
  const Job job;
  const auto stiffnessAt = [&](bool keeps) {
    const SurfaceFit fit = fitSurface(mesh, topology, samples, {.keepsUnsampled = keeps}, job);
    return fit.hessian.at(8, 8)(2, 2);  // across the plane, at the corner far from the sample
  };
  EXPECT_EQ(stiffnessAt(false), 0);
  EXPECT_NEAR(stiffnessAt(true), 2 * (1 / 8.0) / 3, 1e-12);
}

}  // namespace
}  // namespace limber
