#include "fit/surface_rounds.h"

#include <utility>

#include "fit/delaunay_flips.h"
#include "fit/search/fit_solver.h"
#include "fit/surface/surface_fit.h"
#include "fit/tuning.h"

namespace limber {

uint32_t runSurfaceRounds(FitPart& part, const SurfaceRoundsInput& input, std::vector<uint32_t>& corners,
                          Job& job) {
  namespace constants = tuning::surface_rounds;
  FlipLimits flipLimits{part.fixedEdges, part.partners(), input.limits.minAngle};
  if (input.limits.deviation)
    flipLimits.mostLift = constants::kMaxLift * input.maxDeviation / part.frame.diagonal;
  uint32_t flips = 0;
  std::vector<uint32_t> closestTriangles;
  for (int round = 0; round < constants::kRounds; ++round) {
    flips += flipToDelaunay(part.result, flipLimits, corners);
    SurfaceFit fit = fitSurface(part.result, buildIncidence(part.result), input.samples,
                                {.evenness = constants::kEvenness,
                                 .featureEdges = &part.featureEdges,
                                 .startTriangles = std::move(closestTriangles)},
                                job);
    closestTriangles = std::move(fit.closestTriangles);
    part.flatRegions.stiffen(fit.hessian);
    Eigen::MatrixXd step = FitSolver(part.locked, job)
                               .solve({fit.hessian, fit.dampingDiagonal, constants::kDamping}, fit.gradient);
    if (part.mirror) part.mirror->symmetrise(step);
    part.flatRegions.flatten(step);
    part.result = GuardedStep(part.result, input.limits).apply(part.result, step);
    if (part.mirror) part.mirror->symmetrise(part.result);
  }
  return flips;
}

}  // namespace limber
