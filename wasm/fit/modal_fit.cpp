#include "fit/modal_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "base/memory.h"
#include "fit/fit_part.h"
#include "fit/part_limits.h"
#include "fit/part_writer.h"
#include "fit/search/modal_search.h"
#include "fit/surface/original_surface.h"
#include "fit/surface_rounds.h"

namespace limber {

namespace {

constexpr double kTargetShare = 0.3;  // of the time of a search, taken by the modes of the original

// The context that all parts of a call share.
struct FitContext {
  const ModalFitOptions& options;
  StartResult start;
  std::function<void(double)> report;  // takes the completed fraction of the current part
  Job& job;
};

OriginalSurface surfaceOf(const FitPart& part, uint32_t samplesPerTriangle) {
  return {part.original, samplesPerTriangle * part.result.triangleCount(), part.originalFeatureEdges};
}

void findFlatRegions(FitPart& part, const OriginalSurface& surface) {
  part.flatRegions = FlatRegions(part.original, surface.tree, part.result, buildIncidence(part.result));
}

// The largest root mean square distance that a search may use.
double budgetOf(const FitPart& part, const FitSamples& samples, const Job& job) {
  const SampleDistance start = sampleDistance(part.result, samples, job);
  return std::max(tuning::budget::kGrowth * std::sqrt(start.meanSquare), tuning::budget::kMin);
}

// Mean squares of the mismatch of modes.
struct SearchErrors {
  double before, after;
};

// Moves the vertices of part.result. Returns nothing if a body has no elastic modes.
std::optional<SearchErrors> searchModes(FitPart& part, const OriginalSurface& surface,
                                        const SearchLimits& limits, const FitContext& context) {
  const ElasticMaterial material =
      unitMaterial(context.options.thickness / part.frame.diagonal, context.options.poisson);
  ModalTarget target(part.original, part.result,
                     {material, context.options.modeCount, part.pinnedOriginal, part.pinnedResult,
                      part.isLarge, context.options.coarseVertices},
                     context.job);
  context.report(kTargetShare);
  if (target.empty()) return std::nullopt;
  ModalSearch search({part, surface.tree, surface.samples, target}, limits, context.job);
  part.result =
      search.run([&](double fraction) { context.report(kTargetShare + (1 - kTargetShare) * fraction); });
  return SearchErrors{search.meanSquareBefore(), search.meanSquareAfter()};
}

// For small errors the relative error of a frequency is half of that of its eigenvalue. In %.
void addErrors(const SearchErrors& errors, ModalFitResult& fitted) {
  fitted.errorBefore.push_back(50 * std::sqrt(errors.before));
  fitted.errorAfter.push_back(50 * std::sqrt(errors.after));
}

void fitLarge(FitPart& part, const FitContext& context, ModalFitResult& fitted) {
  if (memoryLeft() < tuning::large::kBytesPerVertex * part.original.vertexCount()) {
    ++fitted.tooLarge;
    return;
  }
  const OriginalSurface surface = surfaceOf(part, tuning::surface::kLargeSamplesPerTriangle);
  findFlatRegions(part, surface);
  const PartLimits partLimits(part, surface.tree, {context.options.maxDeviation, context.options.minAngle});
  const SearchLimits limits{.budget = budgetOf(part, surface.samples, context.job),
                            .steps = partLimits.steps,
                            .effort = tuning::kLargeSearch};
  const std::optional<SearchErrors> errors = searchModes(part, surface, limits, context);
  if (!errors) return;
  addErrors(*errors, fitted);
  ++fitted.large;
  writePart(part, unflipped(part.result).corners, context.start, fitted.result);
}

SearchLimits limitsOf(const FitPart& part, const FitSamples& samples, const StepLimits& steps,
                      const Job& job) {
  SearchLimits limits{.budget = budgetOf(part, samples, job),
                      .favourSpeed = part.result.vertexCount() > tuning::stopping::kFavourSpeedVertices,
                      .steps = steps};
  if (part.result.vertexCount() > tuning::stopping::kManyVertices)
    limits.effort.goodEnough = tuning::stopping::kGoodEnoughOfMany;
  return limits;
}

void fitPart(FitPart& part, const FitContext& context, ModalFitResult& fitted) {
  const OriginalSurface surface = surfaceOf(part, tuning::surface::kSamplesPerTriangle);
  findFlatRegions(part, surface);
  const PartLimits partLimits(part, surface.tree, {context.options.maxDeviation, context.options.minAngle});
  const SearchLimits limits = limitsOf(part, surface.samples, partLimits.steps, context.job);
  FitPart unprepared = part;
  std::vector<uint32_t> corners = unflipped(part.result).corners;
  uint32_t flips = runSurfaceRounds(part, {surface.samples, partLimits.steps, context.options.maxDeviation},
                                    corners, context.job);
  std::optional<SearchErrors> errors = searchModes(part, surface, limits, context);
  if (errors && errors->after > tuning::search::kRetryAbove) {
    const std::optional<SearchErrors> second = searchModes(unprepared, surface, limits, context);
    if (second && second->after < errors->after) {
      std::swap(part, unprepared);
      corners = unflipped(part.result).corners;
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
  fitted.result.flips = unflipped(result.mesh);
  if (result.mesh.triangleCount() == original.triangleCount()) return fitted;
  std::optional<ResultMirror> mirror;
  if (!options.mirror.empty()) mirror = mirrorOfResult(original, result, options.mirror);
  const StartResult start{result.mesh, mirror ? &*mirror : nullptr};
  const FitConstraints constraints = options.constraints();
  auto [parts, tooLarge] = findFitParts(original, result, constraints, start.mirror);
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
