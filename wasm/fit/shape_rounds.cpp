#include "fit/shape_rounds.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/tuning.h"
#include "linear/conjugate_gradients.h"

namespace limber {

ShapeRounds::ShapeRounds(FitPart& part, const OriginalSurface& original, const StepLimits& limits, Job& job)
    : part_(part), samples_(original.samples), limits_(limits), job_(job), wanted_(original.sizes) {
  if (isClosed())
    areaRange_ = std::abs(measureSizes(part.result, buildIncidence(part.result))[0] - wanted_[0]);
  SampleDistance start = sampleDistance(part.result, samples_, job);
  startDistance_ = std::sqrt(start.meanSquare);
  closestTriangles_ = std::move(start.closestTriangles);
}

void ShapeRounds::move() {
  TriangleMesh& mesh = part_.result;
  const Eigen::VectorXd step = nextStep();
  job_.check();
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
                               .startTriangles = std::move(closestTriangles_)},
                              job_);
  closestTriangles_ = std::move(fit.closestTriangles);
  job_.check();
  part_.flatRegions.stiffen(fit.hessian);
  return stepOf(fit, measureSizes(mesh, topology), sizeGradients(mesh, topology));
}

// The multipliers cost lambda^T C^T A^-1 C lambda, and the step gains g^T A^-1 g without them.
Eigen::VectorXd ShapeRounds::stepOf(const SurfaceFit& fit, const Eigen::Vector2d& sizes,
                                    const Eigen::MatrixX2d& sizeGradients) const {
  Eigen::MatrixXd columns(fit.gradient.size(), 3);
  columns << fit.gradient, sizeGradients;
  if (part_.mirror) part_.mirror->symmetrise(columns);
  const ShiftedMatrix matrix{fit.hessian, fit.dampingDiagonal, tuning::surface_rounds::kDamping,
                             part_.locked};
  const auto solve = [&](const auto& right) -> Eigen::MatrixXd {
    Eigen::MatrixXd solved = conjugateGradients(matrix, right, job_);
    part_.flatRegions.flatten(solved);
    return solved;
  };
  const auto conditions = columns.rightCols<2>();
  const Eigen::MatrixXd solved = solve(columns.leftCols(isClosed() ? 1 : 3));
  const Eigen::VectorXd free = solved.col(0);
  const Eigen::Vector2d change = wantedChange(sizes + conditions.transpose() * free);
  // The area of a closed part usually stays within its range without a condition.
  if (change.isZero(0)) return free;
  const Eigen::MatrixXd responses = isClosed() ? solve(conditions) : solved.rightCols<2>();
  const Eigen::Matrix2d response = conditions.transpose() * responses;
  Eigen::Vector2d multipliers = response.completeOrthogonalDecomposition().solve(change);
  const double gain = fit.gradient.dot(free), cost = multipliers.dot(response * multipliers);
  if (!(cost > 0) || !(gain > 0)) return free;
  multipliers *= std::min(1.0, std::sqrt(gain / cost));
  return free + responses * multipliers;
}

// The remaining change from the predicted sizes to the wanted ones.
Eigen::Vector2d ShapeRounds::wantedChange(const Eigen::Vector2d& planned) const {
  Eigen::Vector2d change = wanted_ - planned;
  change[0] -= std::clamp(change[0], -areaRange_, areaRange_);
  return change;
}

}  // namespace limber
