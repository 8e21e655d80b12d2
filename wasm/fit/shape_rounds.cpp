#include "fit/shape_rounds.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/tuning.h"
#include "modes/vertex_limits.h"

namespace limber {

ShapeRounds::ShapeRounds(FitPart& part, const OriginalSurface& original, const StepLimits& limits, Job& job)
    : part_(part), samples_(original.samples), limits_(limits), job_(job), wanted_(original.sizes) {
  if (wanted_[1] == 0)
    areaRange_ = std::abs(measureSizes(part.result, buildIncidence(part.result)).values[0] - wanted_[0]);
  SampleDistance start = sampleDistance(part.result, samples_);
  startDistance_ = std::sqrt(start.meanSquare);
  closestTriangles_ = std::move(start.closestTriangles);
}

void ShapeRounds::move() {
  TriangleMesh& mesh = part_.result;
  const Eigen::VectorXd step = nextStep();
  mesh = GuardedStep(mesh, limits_).apply(mesh, step);
  if (part_.mirror) part_.mirror->symmetrise(mesh);
}

Eigen::VectorXd ShapeRounds::nextStep() {
  const TriangleMesh& mesh = part_.result;
  const Topology topology = buildIncidence(mesh);
  SurfaceFit fit = fitSurface(mesh, topology, samples_,
                              {.evenness = tuning::surface_rounds::kEvenness,
                               .normalWeight = NormalWeight::Angle,
                               .keepsUnsampled = true,
                               .featureEdges = &part_.featureEdges,
                               .startTriangles = std::move(closestTriangles_)});
  closestTriangles_ = std::move(fit.closestTriangles);
  part_.flatRegions.stiffen(fit.hessian);
  return stepOf(fit, measureSizes(mesh, topology));
}

// What the multipliers cost is lambda^T C^T A^-1 C lambda, and what the step gains without them g^T A^-1 g.
Eigen::VectorXd ShapeRounds::stepOf(const SurfaceFit& fit, const SheetSizes& now) const {
  Eigen::MatrixXd columns(fit.gradient.size(), 3);
  columns << fit.gradient, now.gradients;
  if (part_.mirror) part_.mirror->symmetrise(columns);
  const Eigen::MatrixXd conditions = columns.rightCols<2>();
  Eigen::MatrixXd solved =
      FitSolver(part_.locked, job_, kLargeResultVertices)
          .solve({fit.hessian, fit.dampingDiagonal, tuning::surface_rounds::kDamping}, std::move(columns));
  part_.flatRegions.flatten(solved);
  const Eigen::VectorXd free = solved.col(0);
  const Eigen::Vector2d change = wantedChange(now.values + conditions.transpose() * free);
  const Eigen::Matrix2d response = conditions.transpose() * solved.rightCols<2>();
  Eigen::Vector2d multipliers = response.completeOrthogonalDecomposition().solve(change);
  const double gain = fit.gradient.dot(free), cost = multipliers.dot(response * multipliers);
  if (!(cost > 0) || !(gain > 0)) return free;
  multipliers *= std::min(1.0, std::sqrt(gain / cost));
  return free + solved.rightCols<2>() * multipliers;
}

// From sizes that are planned to those that are wanted.
Eigen::Vector2d ShapeRounds::wantedChange(const Eigen::Vector2d& planned) const {
  Eigen::Vector2d change = wanted_ - planned;
  change[0] -= std::clamp(change[0], -areaRange_, areaRange_);
  return change;
}

}  // namespace limber
