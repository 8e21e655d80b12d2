#include "fit/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "fit/delaunay_flips.h"
#include "fit/fit_part.h"
#include "fit/part_limits.h"
#include "fit/part_writer.h"
#include "fit/search/distance_bounds.h"
#include "fit/shape_rounds.h"
#include "fit/surface/border_corners.h"
#include "fit/surface/original_surface.h"
#include "fit/tuning.h"
#include "fit/unchanged_surface.h"
#include "modes/vertex_limits.h"

namespace limber {

namespace {

namespace constants = tuning::surface_rounds;

constexpr double kRounding = 1e-6;  // of the diagonal; float32 rounding lifts an edge of a flat mesh by less

// All components are fitted, whatever their size.
FitConstraints constraintsOf(const ShapeFitOptions& options) {
  return {options.charts, options.keepsSeams, options.locked, options.pinned, kLargeResultVertices, ~0u};
}

void lockCorners(FitPart& part, const Topology& topology) {
  const std::vector<uint8_t> isCorner = findBorderCorners(part.result, topology);
  for (uint32_t v = 0; v < isCorner.size(); ++v)
    if (isCorner[v]) part.lock(v);
}

// The context of the fit of a part.
struct ShapeContext {
  const ShapeFitOptions& options;
  StartResult start;
  const std::vector<uint8_t>& isUnchanged;  // per triangle of the whole result
  uint32_t samples;                         // at which the deviation of the current part is measured
  std::function<void(double)> report;       // takes the completed fraction of the current part
  Job& job;
};

// A part's share of the samples of the whole body, by its triangles.
uint32_t samplesOf(const FitPart& part, const TriangleMesh& original, uint32_t wanted) {
  const double all = wanted > 0 ? wanted : kGuardSamples;
  const double share = static_cast<double>(part.original.triangleCount()) / original.triangleCount();
  return static_cast<uint32_t>(std::ceil(share * all));
}

// Limits on flips in addition to fixed edges: no flip displaces the surface by more than the distance at
// which it counts as far.
FlipLimits flipLimits(const FitPart& part, const StepLimits& steps, double startDistance) {
  FlipLimits limits{part.fixedEdges, part.partners(), steps.minAngle};
  limits.mostLift = std::max(tuning::surface::kFarDistance * startDistance, kRounding);
  return limits;
}

void fitPart(FitPart& part, const ShapeContext& context, ShapeFitResult& fitted) {
  const double maxDeviation = context.options.maxDeviation;
  const Topology topology = buildIncidence(part.result);
  lockCorners(part, topology);
  keepUnchanged(part, topology, context.isUnchanged);
  const uint32_t perTriangle =
      part.isLarge ? tuning::surface::kLargeSamplesPerTriangle : tuning::surface::kSamplesPerTriangle;
  const OriginalSurface surface(part.original, perTriangle * part.result.triangleCount(),
                                part.originalFeatureEdges);
  context.job.check();
  part.flatRegions = FlatRegions(part.original, surface.tree, part.result, topology);
  context.job.check();
  const DistanceBounds bounds(surface.tree, part.result, topology);
  const PartLimits limits(part, surface.tree, {maxDeviation, context.options.minAngle, context.samples});
  context.job.check();
  StepLimits steps = limits.steps;
  steps.distanceBounds = &bounds;
  ShapeRounds rounds(part, surface, steps, context.job);
  FlipLimits flips = flipLimits(part, steps, rounds.startDistance());
  if (steps.deviation)
    flips.mostLift = std::min(flips.mostLift, constants::kMaxLift * maxDeviation / part.frame.diagonal);
  std::vector<uint32_t> corners = unflipped(part.result).corners;
  for (int round = 0; round < constants::kRounds; ++round) {
    context.report(static_cast<double>(round) / constants::kRounds);
    fitted.flips += flipToDelaunay(part.result, flips, corners);
    context.job.check();
    rounds.move();
  }
  writePart(part, corners, context.start, fitted.result);
}

}  // namespace

ShapeFitResult fitShape(const TriangleMesh& original, const MeshAt& result, const ShapeFitOptions& options,
                        Job& job) {
  WholePhase phase(job, Phase::Fit);
  ShapeFitResult fitted{result, 0};
  fitted.result.flips = unflipped(result.mesh);
  if (result.mesh.triangleCount() == original.triangleCount()) return fitted;
  std::optional<ResultMirror> mirror;
  if (!options.mirror.empty()) mirror = mirrorOfResult(original, result, options.mirror);
  const StartResult start{result.mesh, mirror ? &*mirror : nullptr};
  const FitConstraints constraints = constraintsOf(options);
  const std::vector<uint8_t> isUnchanged = findUnchangedTriangles(original, result);
  FitParts found = findFitParts(original, result, constraints, start.mirror);
  for (size_t i = 0; i < found.parts.size(); ++i) {
    const auto report = [&](double fraction) {
      phase.report((static_cast<double>(i) + fraction) / static_cast<double>(found.parts.size()));
    };
    const uint32_t samples = samplesOf(found.parts[i], original, options.samples);
    fitPart(found.parts[i], {options, start, isUnchanged, samples, report, job}, fitted);
  }
  return fitted;
}

}  // namespace limber
