#include "fit/modal_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/memory.h"
#include "base/parallel.h"
#include "compare/fidelity.h"
#include "compare/surface_distance.h"
#include "mesh/quality.h"
#include "mesh/repair/inspect.h"
#include "modes/find_modes.h"
#include "shapes.h"
#include "simplify/simplify.h"
#include "surfaces.h"

namespace limber {
namespace {

TriangleMesh wavySheet() {
  TriangleMesh mesh = shapes::grid(18, 14, 1, 0.8);
  for (Vec3& p : mesh.positions) p.z = static_cast<float>(0.06 * std::sin(5 * p.x) * std::cos(4 * p.y));
  return mesh;
}

MeshAt simplified(const TriangleMesh& mesh, double ratio) {
  Job job;
  SimplifyOptions options;
  options.method = Method::Limber;
  options.sizeWeight = 0.01;
  options.qualityWeight = 0.1;
  return meshAt(mesh, simplify(mesh, {}, options, job), static_cast<uint32_t>(ratio * mesh.triangleCount()));
}

double thicknessOf(const TriangleMesh& mesh) {
  return 0.02 * bounds(mesh).diagonal();
}

ModalFitResult fitted(const TriangleMesh& mesh, const MeshAt& start, std::span<const uint8_t> locked = {},
                      Charts charts = {}) {
  Job job;
  ModalFitOptions options;
  options.thickness = thicknessOf(mesh);
  options.charts = charts;
  options.locked = locked;
  return fitModes(mesh, start, options, job);
}

double frequencyError(const TriangleMesh& original, const TriangleMesh& result) {
  Job job;
  return compareFidelity(original, result, {6, {1e6, 0.3, 1000, thicknessOf(original), 1}}, job)
      .frequencyErrorMean;
}

TEST(ModalFit, bringsTheFrequenciesOfAClosedAndAnOpenMeshToThoseOfTheOriginal) {
  for (const TriangleMesh& mesh : {surfaces::bumpySphere(), wavySheet()}) {
    const MeshAt start = simplified(mesh, 0.3);
    const ModalFitResult fit = fitted(mesh, start);
    EXPECT_LT(fit.errorAfter.at(0), fit.errorBefore.at(0));
    // An independent measure: another solve and another matching of modes.
    EXPECT_LT(frequencyError(mesh, fit.result.mesh), 0.8 * frequencyError(mesh, start.mesh));
  }
}

std::vector<uint8_t> clampedSide(const TriangleMesh& mesh) {
  std::vector<uint8_t> marks(mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) marks[v] = mesh.positions[v].x < 0.12;
  return marks;
}

// The first frequencies of a sheet that is clamped along that side.
std::vector<double> clampedOmega(const TriangleMesh& mesh) {
  Job job;
  ModesOptions options{ElasticModel::Shell, 4, {1e6, 0.3, 1000, 0.02, 1}};
  const std::vector<uint8_t> clamped = clampedSide(mesh);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (clamped[v]) options.pinned.push_back(v);
  std::vector<double> omega;
  for (const Mode& mode : findModes(mesh, options, true, job).modes) omega.push_back(mode.omega);
  return omega;
}

double clampedError(const TriangleMesh& original, const TriangleMesh& result) {
  const std::vector<double> a = clampedOmega(original), b = clampedOmega(result);
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += std::abs(b.at(i) / a[i] - 1) / static_cast<double>(a.size());
  return sum;
}

// A result whose vertices on the clamped side are all kept.
MeshAt lockedResult(const TriangleMesh& mesh, const std::vector<uint8_t>& locked, double ratio) {
  Job job;
  SimplifyOptions options;
  options.method = Method::Limber;
  options.sizeWeight = 0.01;
  options.qualityWeight = 0.1;
  options.constraints.locked = locked;
  const auto faces = static_cast<uint32_t>(ratio * mesh.triangleCount());
  return meshAt(mesh, simplify(mesh, {}, options, job), faces);
}

TEST(ModalFit, fitsThePinnedBodyWhereItIsPinned) {
  Job job;
  const TriangleMesh mesh = wavySheet();
  const std::vector<uint8_t> clamped = clampedSide(mesh);
  const auto pins = PinnedVertices::fromMask(clamped);
  const MeshAt start = lockedResult(mesh, clamped, 0.5);
  const ModalFitResult locked = fitModes(mesh, start, {.thickness = 0.02, .locked = clamped}, job);
  const ModalFitResult pinned = fitModes(mesh, start, {.thickness = 0.02, .pinned = pins}, job);
  const double error = clampedError(mesh, pinned.result.mesh);
  EXPECT_LT(error, 0.6 * clampedError(mesh, start.mesh));
  EXPECT_LT(error, 0.8 * clampedError(mesh, locked.result.mesh));
  for (const uint32_t v : pins) {
    const uint32_t there = start.vertexOfInput[v];
    EXPECT_EQ(pinned.result.mesh.positions[there], start.mesh.positions[there]);
  }
}

// With so few faces a fit to the modes of the free body may be as good by chance, but both help a lot.
TEST(ModalFit, fitsThePinnedBodyOfVeryFewFaces) {
  Job job;
  const TriangleMesh mesh = wavySheet();
  const std::vector<uint8_t> clamped = clampedSide(mesh);
  const MeshAt start = lockedResult(mesh, clamped, 1 / 3.0);
  const ModalFitResult pinned =
      fitModes(mesh, start, {.thickness = 0.02, .pinned = PinnedVertices::fromMask(clamped)}, job);
  EXPECT_LT(clampedError(mesh, pinned.result.mesh), 0.6 * clampedError(mesh, start.mesh));
}

TEST(ModalFit, keepsFacesTopologyAndTheDistanceWithinItsBudget) {
  Job job;
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.3);
  const TriangleMesh after = fitted(mesh, start).result.mesh;
  EXPECT_EQ(after.triangleCount(), start.mesh.triangleCount());
  const Inspection was = inspect(start.mesh), is = inspect(after);
  EXPECT_EQ(is.components, was.components);
  EXPECT_EQ(is.boundaryLoops, was.boundaryLoops);
  EXPECT_EQ(is.genus, was.genus);
  EXPECT_EQ(is.nonManifoldEdges, 0u);
  const double limit = 1e-3 * bounds(mesh).diagonal();
  const double before = measureSurfaceDistance(mesh, start.mesh, {}, job).mean;
  EXPECT_LT(measureSurfaceDistance(mesh, after, {}, job).mean, 2 * std::max(before, limit));
  EXPECT_GT(measureQuality(after).minAngle, 0.6 * measureQuality(start.mesh).minAngle);
}

TEST(ModalFit, turnsNoFaceOver) {
  const TriangleMesh mesh = wavySheet();
  const TriangleMesh after = fitted(mesh, simplified(mesh, 0.3)).result.mesh;
  for (uint32_t t = 0; t < after.triangleCount(); ++t) EXPECT_GT(areaNormal(after, t).z, 0);
}

std::vector<uint8_t> everySeventh(const TriangleMesh& mesh) {
  std::vector<uint8_t> marks(mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < mesh.vertexCount(); v += 7) marks[v] = 1;
  return marks;
}

void expectSeventhsUnmoved(const TriangleMesh& mesh, const MeshAt& start, const TriangleMesh& after) {
  for (uint32_t v = 0; v < mesh.vertexCount(); v += 7) {
    const uint32_t there = start.vertexOfInput[v];
    EXPECT_EQ(after.positions[there], start.mesh.positions[there]);
  }
}

void expectTheSameBorder(const TriangleMesh& before, const TriangleMesh& after) {
  const Bounds was = bounds(before), is = bounds(after);
  EXPECT_NEAR(is.low.x, was.low.x, 2e-3);
  EXPECT_NEAR(is.high.x, was.high.x, 2e-3);
  EXPECT_NEAR(is.low.y, was.low.y, 2e-3);
  EXPECT_NEAR(is.high.y, was.high.y, 2e-3);
}

TEST(ModalFit, movesNoLockedVertexAndNoBorder) {
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.3);
  const std::vector<uint8_t> locked = everySeventh(mesh);
  const TriangleMesh after = fitted(mesh, start, locked).result.mesh;
  expectSeventhsUnmoved(mesh, start, after);
  expectTheSameBorder(start.mesh, after);
}

TEST(ModalFit, flipsNoEdgeOfASeamAndTellsWhereCornersComeFrom) {
  const TriangleMesh mesh = wavySheet();
  // Two materials, left and right.
  std::vector<uint32_t> groups;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    groups.push_back(mesh.corner(t, 0).x + mesh.corner(t, 1).x + mesh.corner(t, 2).x > 1.5);
  Job job;
  SimplifyOptions options;
  options.method = Method::Limber;
  options.sizeWeight = 0.01;
  options.qualityWeight = 0.1;
  options.constraints.groups = groups;
  const MeshAt start = meshAt(mesh, simplify(mesh, {}, options, job), 130);
  const MeshAt after = fitted(mesh, start, {}, {{}, groups}).result;
  for (uint32_t t = 0; t < after.mesh.triangleCount(); ++t)
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t before = after.flips.corners[3 * t + c];
      EXPECT_EQ(after.flips.triangles[before / 3][before % 3], after.mesh.triangles[t][c]);
      EXPECT_EQ(groups[after.inputOfTriangle[before / 3]], groups[after.inputOfTriangle[t]]);
    }
  double left = 0, right = 1;
  for (uint32_t t = 0; t < after.mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c)
      (groups[after.inputOfTriangle[t]] ? right : left) = groups[after.inputOfTriangle[t]]
                                                              ? std::min(right, after.mesh.corner(t, c).x)
                                                              : std::max(left, after.mesh.corner(t, c).x);
  EXPECT_NEAR(left, 0.5, 5e-3);
  EXPECT_NEAR(right, 0.5, 5e-3);
}

// A chart for every quad of two triangles.
std::vector<uint32_t> quadCharts(const TriangleMesh& mesh) {
  std::vector<uint32_t> wedges;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) wedges.push_back(t / 2 * mesh.vertexCount() + v);
  return wedges;
}

TEST(ModalFit, movesSeamsWhereTheyNeedNotBeKeptButFlipsNoEdgeBetweenCharts) {
  Job job;
  const TriangleMesh mesh = wavySheet();
  const std::vector<uint32_t> wedges = quadCharts(mesh);
  const MeshAt start = simplified(mesh, 0.3);
  ModalFitOptions options{.thickness = thicknessOf(mesh), .charts = {wedges, {}}};
  const ModalFitResult kept = fitModes(mesh, start, options, job);
  options.keepsSeams = false;
  const ModalFitResult free = fitModes(mesh, start, options, job);
  EXPECT_LT(free.errorAfter.at(0), 0.8 * kept.errorAfter.at(0));
  const MeshAt& after = free.result;
  for (uint32_t t = 0; t < after.mesh.triangleCount(); ++t)
    for (uint32_t c = 0; c < 3; ++c)
      EXPECT_EQ(after.inputOfTriangle[after.flips.corners[3 * t + c] / 3] / 2, after.inputOfTriangle[t] / 2);
}

// A ball on a long thin stick that ends in a small knob: a surface of revolution about the x axis.
TriangleMesh club() {
  constexpr int kAlong = 90, kAround = 24;
  TriangleMesh mesh;
  for (int i = 0; i <= kAlong; ++i) {
    const double x = 1.0 * i / kAlong, ball = 0.04 - (x - 0.2) * (x - 0.2),
                 knob = 0.0025 - (x - 0.95) * (x - 0.95);
    const double radius =
        i == 0 || i == kAlong ? 0 : std::sqrt(std::max({ball, knob, x > 0.2 && x < 0.95 ? 1e-3 : 0.0, 1e-8}));
    for (int j = 0; j < (radius > 0 ? kAround : 1); ++j) {
      const double angle = 2 * std::numbers::pi * j / kAround;
      mesh.positions.push_back({static_cast<float>(x), static_cast<float>(radius * std::cos(angle)),
                                static_cast<float>(radius * std::sin(angle))});
    }
  }
  const auto at = [&](int i, int j) {
    return i == 0 ? 0u : i == kAlong ? mesh.vertexCount() - 1 : 1u + kAround * (i - 1) + j % kAround;
  };
  for (int i = 0; i < kAlong; ++i)
    for (int j = 0; j < kAround; ++j) {
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i + 1 < kAlong) mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  return mesh;
}

TEST(ModalFit, keepsTheShapeOfSmallPartsThatSwing) {
  Job job;
  const TriangleMesh mesh = club();
  const MeshAt start = simplified(mesh, 0.1);
  const ModalFitResult fit = fitted(mesh, start);
  EXPECT_LT(fit.errorAfter.at(0), 0.2 * fit.errorBefore.at(0));
  const auto deviation = [&](const TriangleMesh& result) {
    return measureSurfaceDistance(mesh, result, {}, job).hausdorff;
  };
  EXPECT_LT(deviation(fit.result.mesh), 2.5 * deviation(start.mesh));
}

// The distance from the nearest side of the paper's bar, 1 x 1 x 3.
double distanceFromSides(const Vec3& p) {
  return std::min(
      {std::abs(p.x), std::abs(p.x - 1), std::abs(p.y), std::abs(p.y - 1), std::abs(p.z), std::abs(p.z - 3)});
}

TEST(ModalFit, keepsFlatSidesFlatAndTheirEdgesStraight) {
  const TriangleMesh mesh = shapes::box(8, 8, 24, 0.125);
  const MeshAt start = simplified(mesh, 0.25);
  const ModalFitResult fit = fitted(mesh, start);
  EXPECT_LT(fit.errorAfter.at(0), 0.6 * fit.errorBefore.at(0));
  EXPECT_NE(fit.result.mesh.positions, start.mesh.positions);
  for (const Vec3& p : fit.result.mesh.positions) EXPECT_LT(distanceFromSides(p), 1e-6);
  Job job;
  EXPECT_LT(measureSurfaceDistance(mesh, fit.result.mesh, {}, job).hausdorff, 1e-5);
}

TEST(ModalFit, doesNothingToAWholeMesh) {
  const TriangleMesh mesh = wavySheet();
  const MeshAt whole = simplified(mesh, 1);
  const ModalFitResult fit = fitted(mesh, whole);
  EXPECT_EQ(fit.result.mesh.positions, mesh.positions);
  EXPECT_EQ(fit.result.mesh.triangles, mesh.triangles);
}

template <class Fit>
void expectTheSameOnAnyNumberOfThreads(const Fit& fit) {
  std::vector<std::vector<Vec3>> found;
  for (int threads : {1, 2, 4}) {
    setThreadCount(threads);
    found.push_back(fit().result.mesh.positions);
  }
  setThreadCount(1);
  EXPECT_EQ(found[1], found[0]);
  EXPECT_EQ(found[2], found[0]);
}

TEST(ModalFit, isTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.2);
  expectTheSameOnAnyNumberOfThreads([&] { return fitted(mesh, start); });
}

// Options that treat a small mesh as if its result had more than 20,000 vertices.
ModalFitOptions asLarge(const TriangleMesh& mesh) {
  return {.thickness = thicknessOf(mesh), .largeVertices = 50, .coarseVertices = 120};
}

TEST(LargeModalFit, bringsFrequenciesToThoseOfTheOriginal) {
  Job job;
  for (const TriangleMesh& mesh : {surfaces::bumpySphere(), wavySheet()}) {
    const MeshAt start = simplified(mesh, 0.5);
    const ModalFitResult fit = fitModes(mesh, start, asLarge(mesh), job);
    EXPECT_EQ(fit.large, 1u);
    EXPECT_EQ(fit.tooLarge, 0u);
    EXPECT_LT(fit.errorAfter.at(0), 0.75 * fit.errorBefore.at(0));
    EXPECT_LT(frequencyError(mesh, fit.result.mesh), 0.8 * frequencyError(mesh, start.mesh));
  }
}

TEST(LargeModalFit, turnsNoFaceOverAndKeepsBordersLocksAndTriangles) {
  Job job;
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.5);
  const std::vector<uint8_t> locked = everySeventh(mesh);
  ModalFitOptions options = asLarge(mesh);
  options.locked = locked;
  const TriangleMesh after = fitModes(mesh, start, options, job).result.mesh;
  EXPECT_EQ(after.triangles, start.mesh.triangles);
  EXPECT_NE(after.positions, start.mesh.positions);
  for (uint32_t t = 0; t < after.triangleCount(); ++t) EXPECT_GT(areaNormal(after, t).z, 0);
  expectSeventhsUnmoved(mesh, start, after);
  expectTheSameBorder(start.mesh, after);
}

TEST(LargeModalFit, isTheSameOnAnyNumberOfThreads) {
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.5);
  expectTheSameOnAnyNumberOfThreads([&] {
    Job job;
    return fitModes(mesh, start, asLarge(mesh), job);
  });
}

TEST(LargeModalFit, canBeCancelledAtAnyTime) {
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.5);
  for (double moment : {0.0, 0.3, 0.5}) {
    Job job;
    double reached = 0;
    job.observer = [&](Phase phase, double fraction) {
      EXPECT_EQ(phase, Phase::Fit);
      reached = fraction;
      if (fraction >= moment) job.requestCancel();
    };
    EXPECT_THROW(fitModes(mesh, start, asLarge(mesh), job), Cancelled);
    EXPECT_LT(reached, 1);
  }
}

TEST(LargeModalFit, isLeftOutWhereTheOriginalIsTooLargeOrTheMemoryTooSmall) {
  Job job;
  const TriangleMesh mesh = wavySheet();
  const MeshAt start = simplified(mesh, 0.5);
  ModalFitOptions options = asLarge(mesh);
  options.mostOriginal = 100;
  const auto expectLeft = [&](const ModalFitResult& fit) {
    EXPECT_EQ(fit.tooLarge, 1u);
    EXPECT_TRUE(fit.errorAfter.empty());
    EXPECT_EQ(fit.result.mesh.positions, start.mesh.positions);
  };
  expectLeft(fitModes(mesh, start, options, job));
  setMemoryLimit(1000000);
  const ModalFitResult poor = fitModes(mesh, start, asLarge(mesh), job);
  setMemoryLimit(0);
  expectLeft(poor);
}

}  // namespace
}  // namespace limber
