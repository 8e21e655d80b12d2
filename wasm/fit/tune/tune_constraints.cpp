#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "fit/tune/factor_range.h"
#include "fit/tune/tune_steps.h"

namespace limber {
namespace {

constexpr int kRounds = 20;
constexpr double kGoodError = 0.25;     // %, of the fitted frequencies
constexpr double kLongestChange = 0.7;  // of a logarithm in a round
constexpr double kDamping = 1e-4;  // of the mean diagonal of J J^T: modes of one frequency share their rows
constexpr double kStalled = 0.95;  // of the best error so far; more of it is no progress
constexpr int kPatience = 3;       // rounds without progress

// The change of the logarithms of least norm that takes the residuals to 0 at first order.
Eigen::VectorXd leastNormStep(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual) {
  Eigen::MatrixXd gram = jacobian * jacobian.transpose();
  gram.diagonal().array() += kDamping * gram.diagonal().mean();
  Eigen::VectorXd step = -jacobian.transpose() * gram.ldlt().solve(residual);
  const double longest = step.cwiseAbs().maxCoeff();
  if (longest > kLongestChange) step *= kLongestChange / longest;
  return step;
}

}  // namespace

std::vector<double> tuneConstraints(TuneProblem& problem, const TuneConstraints& constraints,
                                    const GlobalFactors& start, Job& job) {
  std::vector<double> best = factorsOf(start, constraints);
  Eigen::VectorXd x =
      Eigen::Map<Eigen::VectorXd>(best.data(), static_cast<Eigen::Index>(best.size())).array().log();
  double bestError = problem.fittedError();
  int idle = 0;
  for (int round = 0; round < kRounds && bestError > kGoodError && idle < kPatience; ++round) {
    Eigen::MatrixXd jacobian = problem.jacobian();
    if (!constraints.tunesStretch)
      jacobian.leftCols(static_cast<Eigen::Index>(constraints.stretchCount)).setZero();
    x = (x + leastNormStep(jacobian, problem.residuals())).cwiseMax(-kFactorRange).cwiseMin(kFactorRange);
    const Eigen::VectorXd factors = x.array().exp();
    problem.moveTo({factors.begin(), factors.end()}, job);
    if (!problem.isDefinite()) break;
    const double error = problem.fittedError();
    idle = error < kStalled * bestError ? 0 : idle + 1;
    if (error >= bestError) continue;
    bestError = error;
    best = problem.factors();
  }
  if (problem.factors() != best) problem.moveTo(best, job);
  return best;
}

}  // namespace limber
