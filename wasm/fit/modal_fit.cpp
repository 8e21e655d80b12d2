#include "fit/modal_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "base/memory.h"
#include "fit/delaunay_flips.h"
#include "fit/deviation_guard.h"
#include "fit/fit_part.h"
#include "fit/fit_solver.h"
#include "fit/guarded_step.h"
#include "fit/modal_search.h"
#include "fit/modal_target.h"
#include "fit/result_mirror.h"
#include "mesh/quality.h"

namespace limber {

namespace {

constexpr int kSurfaceRounds = 3;
constexpr double kSurfaceHold = 1e-3;  // how firmly vertices hold their places
constexpr uint32_t kSamplesPerTriangle = 6;

constexpr double kMostLift = 0.02;  // by a flip, of the largest deviation where there is one

// The root mean square distance may grow to this much of the simplified mesh's, or to this part of the
// diagonal.
constexpr double kBudget = 1.45, kLeastBudget = 7e-4;
// Where the result has more vertices, rounds take seconds, and 0.1 % of frequency (squared) is good enough.
constexpr uint32_t kManyVertices = 5000;
constexpr double kGoodEnoughOfMany = 4e-6;
constexpr uint32_t kBriskVertices = 1000;  // rounds take tenths of a second

// Of large components: frequencies are off by little, so that residuals are nearly linear and long steps are
// right.
constexpr int kLargeRounds = 6;
constexpr double kLargeGoodEnough = 4e-8;  // 0.01 % of frequency, squared
constexpr double kLargeHold = 5e-4, kLargeWorth = 3500;
constexpr uint32_t kLargeSamplesPerTriangle = 2;
constexpr uint64_t kLargeBytes = 20000;  // that the fit takes for each vertex of the original, as measured

// What stays the same for all parts; `report` takes the fraction of this part that is done.
struct FitCall {
  const ModalFitOptions& options;
  const TriangleMesh& before;  // the result as it came
  const ResultMirror* mirror;  // null where it has none
  std::function<void(double)> report;
  Job& job;
};

// Edges flipped to Delaunay, vertices fitted to the surface.
uint32_t fitToSurface(FitPart& part, const FitSamples& samples, const StepLimits& limits,
                      std::vector<uint32_t>& corners, const FitCall& call) {
  FlipLimits flipLimits{part.fixedEdges, part.partners(), limits.minAngle};
  if (limits.deviation) flipLimits.mostLift = kMostLift * call.options.maxDeviation / part.diagonal;
  uint32_t flips = 0;
  std::vector<uint32_t> touched;
  for (int round = 0; round < kSurfaceRounds; ++round) {
    flips += flipToDelaunay(part.simplified, flipLimits, corners);
    const Topology topology = buildTopology(part.simplified);
    SurfaceFit fit =
        fitSurface(part.simplified, topology, samples, {.lines = &part.lines, .near = std::move(touched)});
    touched = std::move(fit.touched);
    part.flats.hold(fit.stiffness);
    Eigen::MatrixXd step =
        FitSolver(part.locked, call.job).solve({fit.stiffness, fit.inertia, kSurfaceHold}, fit.pull);
    if (part.mirror) part.mirror->symmetrise(step);
    part.flats.flatten(step);
    part.simplified = GuardedStep(part.simplified, limits).apply(part.simplified, step);
    if (part.mirror) part.mirror->symmetrise(part.simplified);
  }
  return flips;
}

Vec3 inFile(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Of a vertex and, where there is a mirror, its image.
void putPlace(uint32_t v, const Vec3& place, const ResultMirror* mirror, std::vector<Vec3>& places) {
  const uint32_t image = mirror ? mirror->partners[v] : v;
  places[v] = inFile(mirror && image == v ? mirror->plane.onto(place) : place);
  if (image != v) places[image] = inFile(mirror->plane.image(places[v]));
}

// A triangle of the result that another one is the image of.
void putImage(uint32_t t, const ResultMirror& mirror, const TriangleMesh& before, MeshAt& result) {
  const uint32_t image = mirror.triangleImages[t];
  for (uint32_t c = 0; c < 3; ++c) {
    const uint32_t from = (3 - c) % 3, v = mirror.partners[result.mesh.triangles[t][from]];
    result.mesh.triangles[image][c] = v;
    const uint32_t source = result.flips.corners[3 * t + from] / 3;
    result.flips.corners[3 * image + c] = cornerAt(before, mirror.triangleImages[source], v);
  }
}

// `corners`: those of the part's triangles after its flips.
void putBack(const FitPart& part, const std::vector<uint32_t>& corners, const FitCall& call, MeshAt& result) {
  for (uint32_t v = 0; v < part.vertexOfResult.size(); ++v) {
    const uint32_t there = part.vertexOfResult[v];
    const bool isOther = part.mirror && part.mirror->partners[v] < v;
    if (!part.locked[v] && !isOther)
      putPlace(there, part.origin + part.diagonal * part.simplified.positions[v], call.mirror,
               result.mesh.positions);
  }
  for (uint32_t t = 0; t < part.triangleOfResult.size(); ++t) {
    const uint32_t there = part.triangleOfResult[t];
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t corner = corners[3 * t + c];
      result.mesh.triangles[there][c] = part.vertexOfResult[part.simplified.triangles[t][c]];
      result.flips.corners[3 * there + c] = 3 * part.triangleOfResult[corner / 3] + corner % 3;
    }
    if (part.hasImage) putImage(there, *call.mirror, call.before, result);
  }
}

// A mean square above this (2.5 % of frequency) is tried once more.
constexpr double kDoubtful = 2.5e-3;

constexpr double kTargetShare = 0.3;  // of the time, until the original's modes are there

// Mean squares of the mismatch before and after; nothing where the original has no modes.
struct Searched {
  double before, after;
};

std::optional<Searched> searchModes(FitPart& part, const FitSamples& samples, const SearchLimits& limits,
                                    const FitCall& call) {
  const ElasticMaterial material = unitMaterial(call.options.thickness / part.diagonal, call.options.poisson);
  ModalTarget target(part.original, part.simplified,
                     {material, call.options.modeCount, part.pinnedOriginal, part.pinned, part.isLarge,
                      call.options.coarseVertices},
                     call.job);
  call.report(kTargetShare);
  if (target.empty()) return std::nullopt;
  ModalSearch search(part, samples, target, limits, call.job);
  part.simplified =
      search.run([&](double fraction) { call.report(kTargetShare + (1 - kTargetShare) * fraction); });
  return Searched{search.meanSquareBefore(), search.meanSquareAfter()};
}

// A frequency is off by half of what its eigenvalue is, for small errors; in %.
void addErrors(const Searched& found, ModalFitResult& fitted) {
  fitted.errorBefore.push_back(50 * std::sqrt(found.before));
  fitted.errorAfter.push_back(50 * std::sqrt(found.after));
}

// Each corner of a mesh, where no edge has been flipped.
std::vector<uint32_t> unflippedCorners(const TriangleMesh& mesh) {
  std::vector<uint32_t> corners(3 * size_t{mesh.triangleCount()});
  std::iota(corners.begin(), corners.end(), 0u);
  return corners;
}

double budgetOf(const FitPart& part, const FitSamples& samples) {
  const SurfaceFit start =
      fitSurface(part.simplified, buildTopology(part.simplified), samples, {.lines = &part.lines});
  return std::max(kBudget * std::sqrt(start.meanSquare), kLeastBudget);
}

// The limits of a part, and what watches over one of them.
struct PartLimits {
  std::optional<DeviationGuard> deviation;
  StepLimits steps;

  PartLimits(const FitPart& part, const ModalFitOptions& options) {
    steps.partners = part.partners();
    if (options.minAngle > 0)
      steps.minAngle = std::min(options.minAngle, measureQuality(part.simplified).minAngle);
    if (options.maxDeviation > 0)
      steps.deviation = &deviation.emplace(part.original, options.maxDeviation / part.diagonal);
  }
  PartLimits(const PartLimits&) = delete;
};

void fitLarge(FitPart& part, const FitCall& call, ModalFitResult& fitted) {
  if (memoryLeft() < kLargeBytes * part.original.vertexCount()) {
    ++fitted.tooLarge;
    return;
  }
  const FitSamples samples = sampleForFit(
      part.original, kLargeSamplesPerTriangle * part.simplified.triangleCount(), part.originalFeatures);
  const PartLimits asked(part, call.options);
  const SearchLimits limits{.budget = budgetOf(part, samples),
                            .mostRounds = kLargeRounds,
                            .goodEnough = kLargeGoodEnough,
                            .firstHold = kLargeHold,
                            .mostWorth = kLargeWorth,
                            .steps = asked.steps};
  const std::optional<Searched> found = searchModes(part, samples, limits, call);
  if (!found) return;
  addErrors(*found, fitted);
  ++fitted.large;
  putBack(part, unflippedCorners(part.simplified), call, fitted.result);
}

void fitPart(FitPart& part, const FitCall& call, ModalFitResult& fitted) {
  const FitSamples samples = sampleForFit(
      part.original, kSamplesPerTriangle * part.simplified.triangleCount(), part.originalFeatures);
  const PartLimits asked(part, call.options);
  SearchLimits limits{.budget = budgetOf(part, samples),
                      .isBrisk = part.simplified.vertexCount() > kBriskVertices,
                      .steps = asked.steps};
  if (part.simplified.vertexCount() > kManyVertices) limits.goodEnough = kGoodEnoughOfMany;
  FitPart plain = part;
  std::vector<uint32_t> corners = unflippedCorners(part.simplified);
  uint32_t flips = fitToSurface(part, samples, asked.steps, corners, call);
  std::optional<Searched> found = searchModes(part, samples, limits, call);
  // Flips and the fit to the surface can harm a mesh of slivers more than the search can mend.
  if (found && found->after > kDoubtful) {
    const std::optional<Searched> second = searchModes(plain, samples, limits, call);
    if (second && second->after < found->after) {
      std::swap(part, plain);
      corners = unflippedCorners(part.simplified);
      flips = 0;
      found = second;
    }
  }
  if (found) addErrors(*found, fitted);
  fitted.flips += flips;
  putBack(part, corners, call, fitted.result);
}

}  // namespace

ModalFitResult fitModes(const TriangleMesh& original, const MeshAt& simplified,
                        const ModalFitOptions& options, Job& job) {
  WholePhase phase(job, Phase::Fit);
  ModalFitResult fitted{simplified, {}, {}, 0, 0, 0};
  fitted.result.flips.triangles = simplified.mesh.triangles;
  fitted.result.flips.corners = unflippedCorners(simplified.mesh);
  if (simplified.mesh.triangleCount() == original.triangleCount()) return fitted;
  std::optional<ResultMirror> mirror;
  if (!options.mirror.empty()) mirror = mirrorOfResult(original, simplified, options.mirror);
  const ResultMirror* const theMirror = mirror ? &*mirror : nullptr;
  auto [parts, tooLarge] = fitParts(original, simplified,
                                    {.charts = options.charts,
                                     .holdsSeams = options.holdsSeams,
                                     .locked = options.locked,
                                     .pinned = options.pinned,
                                     .mirror = theMirror,
                                     .largeVertices = options.largeVertices,
                                     .mostOriginal = options.mostOriginal});
  fitted.tooLarge = tooLarge;
  for (size_t i = 0; i < parts.size(); ++i) {
    const auto report = [&](double fraction) {
      phase.report((static_cast<double>(i) + fraction) / static_cast<double>(parts.size()));
    };
    const FitCall call{options, simplified.mesh, theMirror, report, job};
    if (parts[i].isLarge)
      fitLarge(parts[i], call, fitted);
    else
      fitPart(parts[i], call, fitted);
  }
  return fitted;
}

}  // namespace limber
