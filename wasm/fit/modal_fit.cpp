#include "fit/modal_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "base/memory.h"
#include "fit/fit_part.h"
#include "fit/part_writer.h"
#include "fit/search/deviation_guard.h"
#include "fit/search/modal_search.h"
#include "fit/surface_rounds.h"
#include "mesh/quality.h"

namespace limber {

namespace {

constexpr double kTargetShare = 0.3;  // of the time of a search, until the modes of the original are known

// What is the same for all parts of a call.
struct FitContext {
  const ModalFitOptions& options;
  StartResult start;
  std::function<void(double)> report;  // takes the fraction of the present part that is done
  Job& job;
};

// The limits of a part, and what watches over one of them.
struct PartLimits {
  std::optional<DeviationGuard> deviation;
  StepLimits steps;  // refers to `deviation`

  PartLimits(const FitPart& part, const ModalFitOptions& options) {
    steps.partners = part.partners();
    if (options.minAngle > 0)
      steps.minAngle = std::min(options.minAngle, measureQuality(part.result).minAngle);
    if (options.maxDeviation > 0)
      steps.deviation = &deviation.emplace(part.original, options.maxDeviation / part.frame.diagonal);
  }
  PartLimits(const PartLimits&) = delete;
};

// The corners of a mesh where no edge has been flipped: each comes from itself.
std::vector<uint32_t> unflippedCorners(const TriangleMesh& mesh) {
  std::vector<uint32_t> corners(3 * size_t{mesh.triangleCount()});
  std::iota(corners.begin(), corners.end(), 0u);
  return corners;
}

// The largest root mean square distance that a search may use.
double budgetOf(const FitPart& part, const FitSamples& samples) {
  const SurfaceFit start =
      fitSurface(part.result, buildTopology(part.result), samples, {.featureEdges = &part.featureEdges});
  return std::max(tuning::budget::kGrowth * std::sqrt(start.meanSquare), tuning::budget::kLeast);
}

// Mean squares of the mismatch of modes.
struct SearchErrors {
  double before, after;
};

// Moves the vertices of part.result. Nothing where the original has no elastic modes.
std::optional<SearchErrors> searchModes(FitPart& part, const FitSamples& samples, const SearchLimits& limits,
                                        const FitContext& context) {
  const ElasticMaterial material =
      unitMaterial(context.options.thickness / part.frame.diagonal, context.options.poisson);
  ModalTarget target(part.original, part.result,
                     {material, context.options.modeCount, part.pinnedOriginal, part.pinnedResult,
                      part.isLarge, context.options.coarseVertices},
                     context.job);
  context.report(kTargetShare);
  if (target.empty()) return std::nullopt;
  ModalSearch search({part, samples, target}, limits, context.job);
  part.result =
      search.run([&](double fraction) { context.report(kTargetShare + (1 - kTargetShare) * fraction); });
  return SearchErrors{search.meanSquareBefore(), search.meanSquareAfter()};
}

// For small errors a frequency is off by half of what its eigenvalue is. In %.
void addErrors(const SearchErrors& errors, ModalFitResult& fitted) {
  fitted.errorBefore.push_back(50 * std::sqrt(errors.before));
  fitted.errorAfter.push_back(50 * std::sqrt(errors.after));
}

void fitLarge(FitPart& part, const FitContext& context, ModalFitResult& fitted) {
  if (memoryLeft() < tuning::large::kBytesPerVertex * part.original.vertexCount()) {
    ++fitted.tooLarge;
    return;
  }
  const FitSamples samples =
      sampleForFit(part.original, tuning::surface::kLargeSamplesPerTriangle * part.result.triangleCount(),
                   part.originalFeatureEdges);
  const PartLimits partLimits(part, context.options);
  const SearchLimits limits{
      .budget = budgetOf(part, samples), .steps = partLimits.steps, .effort = tuning::kLargeSearch};
  const std::optional<SearchErrors> errors = searchModes(part, samples, limits, context);
  if (!errors) return;
  addErrors(*errors, fitted);
  ++fitted.large;
  writePart(part, unflippedCorners(part.result), context.start, fitted.result);
}

SearchLimits limitsOf(const FitPart& part, const FitSamples& samples, const StepLimits& steps) {
  SearchLimits limits{.budget = budgetOf(part, samples),
                      .favourSpeed = part.result.vertexCount() > tuning::stopping::kFavourSpeedVertices,
                      .steps = steps};
  if (part.result.vertexCount() > tuning::stopping::kManyVertices)
    limits.effort.goodEnough = tuning::stopping::kGoodEnoughOfMany;
  return limits;
}

void fitPart(FitPart& part, const FitContext& context, ModalFitResult& fitted) {
  const FitSamples samples =
      sampleForFit(part.original, tuning::surface::kSamplesPerTriangle * part.result.triangleCount(),
                   part.originalFeatureEdges);
  const PartLimits partLimits(part, context.options);
  const SearchLimits limits = limitsOf(part, samples, partLimits.steps);
  FitPart unprepared = part;
  std::vector<uint32_t> corners = unflippedCorners(part.result);
  uint32_t flips =
      runSurfaceRounds(part, {samples, partLimits.steps, context.options.maxDeviation}, corners, context.job);
  std::optional<SearchErrors> errors = searchModes(part, samples, limits, context);
  if (errors && errors->after > tuning::search::kRetryAbove) {
    const std::optional<SearchErrors> second = searchModes(unprepared, samples, limits, context);
    if (second && second->after < errors->after) {
      std::swap(part, unprepared);
      corners = unflippedCorners(part.result);
      flips = 0;
      errors = second;
    }
  }
  if (errors) addErrors(*errors, fitted);
  fitted.flips += flips;
  writePart(part, corners, context.start, fitted.result);
}

}  // namespace

ModalFitResult fitModes(const TriangleMesh& original, const MeshAt& result, const ModalFitOptions& options,
                        Job& job) {
  WholePhase phase(job, Phase::Fit);
  ModalFitResult fitted{result, {}, {}, 0, 0, 0};
  fitted.result.flips.triangles = result.mesh.triangles;
  fitted.result.flips.corners = unflippedCorners(result.mesh);
  if (result.mesh.triangleCount() == original.triangleCount()) return fitted;
  std::optional<ResultMirror> mirror;
  if (!options.mirror.empty()) mirror = mirrorOfResult(original, result, options.mirror);
  const StartResult start{result.mesh, mirror ? &*mirror : nullptr};
  auto [parts, tooLarge] = findFitParts(original, result, options, start.mirror);
  fitted.tooLarge = tooLarge;
  for (size_t i = 0; i < parts.size(); ++i) {
    const auto report = [&](double fraction) {
      phase.report((static_cast<double>(i) + fraction) / static_cast<double>(parts.size()));
    };
    const FitContext context{options, start, report, job};
    if (parts[i].isLarge)
      fitLarge(parts[i], context, fitted);
    else
      fitPart(parts[i], context, fitted);
  }
  return fitted;
}

}  // namespace limber
