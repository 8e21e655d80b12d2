#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/tune/steps/tune_steps.h"

namespace limber {
namespace {

constexpr int kRounds = 20;
constexpr double kGoodError = 0.25;     // %, of the fitted frequencies
constexpr double kLongestChange = 0.7;  // initial limit on the change of a logarithm in a round
constexpr double kDamping = 1e-4;  // of the mean diagonal of J J^T: modes of one frequency share their rows
constexpr double kShortestChange = 0.05;  // the limit is halved down to this if errors grow
constexpr int kPasses = 8;                // to find the unknowns that reach their bounds

// Limits of the logarithms, or of their changes in a round.
struct Bounded {
  Eigen::VectorXd least, most;
};

// The change of the logarithms of least norm that makes the residuals 0 to first order, within bounds:
// unknowns that would exceed theirs stop there, and the others compensate.
Eigen::VectorXd leastNormStep(Eigen::MatrixXd jacobian, const Eigen::VectorXd& residual,
                              const Bounded& bounds) {
  Eigen::VectorXd step = Eigen::VectorXd::Zero(jacobian.cols()), left = residual;
  double damping = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::MatrixXd gram = jacobian * jacobian.transpose();
    if (pass == 0) damping = kDamping * gram.diagonal().mean();
    gram.diagonal().array() += damping;
    const Eigen::VectorXd free = -jacobian.transpose() * gram.ldlt().solve(left);
    bool isStopped = false;
    for (Eigen::Index c = 0; c < step.size(); ++c) {
      if (free[c] == 0) continue;  // already at its bound, or without any effect
      step[c] = std::clamp(free[c], bounds.least[c], bounds.most[c]);
      if (step[c] == free[c] || pass + 1 == kPasses) continue;
      isStopped = true;
      left += jacobian.col(c) * step[c];
      jacobian.col(c).setZero();
    }
    if (!isStopped) break;
  }
  return step;
}

// The least and the greatest logarithm of the factor of each constraint.
Bounded rangesOf(const TuneConstraints& constraints) {
  const auto count = static_cast<Eigen::Index>(constraints.all.size());
  const auto stretches = static_cast<Eigen::Index>(constraints.stretchCount);
  Bounded ranges{Eigen::VectorXd::Constant(count, constraints.bendRange.least),
                 Eigen::VectorXd::Constant(count, constraints.bendRange.most)};
  ranges.least.head(stretches).setConstant(constraints.stretchRange.least);
  ranges.most.head(stretches).setConstant(constraints.stretchRange.most);
  return ranges;
}

}  // namespace

std::vector<double> tuneConstraints(TuneProblem& problem, const TuneConstraints& constraints,
                                    const GlobalFactors& start, Job& job) {
  std::vector<double> best = factorsOf(start, constraints);
  Eigen::VectorXd x =
      Eigen::Map<Eigen::VectorXd>(best.data(), static_cast<Eigen::Index>(best.size())).array().log();
  const auto [least, most] = rangesOf(constraints);
  Eigen::VectorXd bestX = x;
  double bestError = problem.fittedError(), longest = kLongestChange;
  for (int round = 0; round < kRounds && bestError > kGoodError && longest > kShortestChange; ++round) {
    Eigen::MatrixXd jacobian = problem.jacobian();
    if (!constraints.tunesStretch)
      jacobian.leftCols(static_cast<Eigen::Index>(constraints.stretchCount)).setZero();
    const Bounded bounds{(least - x).cwiseMax(-longest), (most - x).cwiseMin(longest)};
    x += leastNormStep(std::move(jacobian), problem.residuals(), bounds);
    const Eigen::VectorXd factors = x.array().exp();
    problem.moveTo({factors.begin(), factors.end()}, job);
    if (!problem.isDefinite()) break;
    const double error = problem.fittedError();
    if (error < bestError) {
      bestError = error;
      bestX = x;
      best = problem.factors();
      continue;
    }
    longest /= 2;
    x = bestX;
    problem.moveTo(best, job);
  }
  if (problem.factors() != best) problem.moveTo(best, job);
  return best;
}

}  // namespace limber
