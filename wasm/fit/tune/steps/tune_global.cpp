#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "fit/tune/steps/factor_range.h"
#include "fit/tune/steps/tune_steps.h"

namespace limber {
namespace {

constexpr int kRounds = 8;
constexpr int kWorseRounds = 2;    // in a row end the search: a single one may be modes that change partners
constexpr double kSettled = 0.01;  // a step in logarithms: half a percent in frequencies

// The derivatives with respect to the logarithms of the two factors: fitted modes x 2.
Eigen::MatrixXd sumsByKind(const Eigen::MatrixXd& jacobian, size_t stretchCount) {
  const auto stretches = static_cast<Eigen::Index>(stretchCount);
  Eigen::MatrixXd sums(jacobian.rows(), 2);
  sums.col(0) = jacobian.leftCols(stretches).rowwise().sum();
  sums.col(1) = jacobian.rightCols(jacobian.cols() - stretches).rowwise().sum();
  return sums;
}

}  // namespace

std::vector<double> factorsOf(const GlobalFactors& factors, const TuneConstraints& constraints) {
  std::vector<double> all(constraints.all.size(), factors.bend);
  std::fill_n(all.begin(), constraints.stretchCount, factors.stretch);
  return all;
}

GlobalFactors tuneGlobally(TuneProblem& problem, const TuneConstraints& constraints, Job& job) {
  GlobalFactors best;
  const FactorRange &stretch = constraints.stretchRange, &bend = constraints.bendRange;
  const Eigen::Vector2d least(stretch.least, bend.least), most(stretch.most, bend.most);
  Eigen::Vector2d x = Eigen::Vector2d::Zero();
  int worseRounds = 0;
  double bestSquares = problem.residuals().squaredNorm();
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd jacobian = sumsByKind(problem.jacobian(), constraints.stretchCount);
    if (!constraints.tunesStretch) jacobian.col(0).setZero();
    const Eigen::VectorXd residual = problem.residuals();
    const double scatter = residual.squaredNorm() / static_cast<double>(residual.size());
    const double drawn = std::max(scatter, kMinScatter) / (kPriorDeviation * kPriorDeviation);
    const Eigen::Matrix2d normal = jacobian.transpose() * jacobian + drawn * Eigen::Matrix2d::Identity();
    const Eigen::Vector2d gradient = jacobian.transpose() * residual + drawn * x;
    const Eigen::Vector2d next = (x - normal.ldlt().solve(gradient)).cwiseMax(least).cwiseMin(most);
    if ((next - x).cwiseAbs().maxCoeff() < kSettled) break;
    x = next;
    const GlobalFactors factors{std::exp(x[0]), std::exp(x[1])};
    problem.moveTo(factorsOf(factors, constraints), job);
    if (!problem.isDefinite()) break;
    const double squares = problem.residuals().squaredNorm();
    if (squares < bestSquares) {
      bestSquares = squares;
      best = factors;
      worseRounds = 0;
    } else if (++worseRounds == kWorseRounds) {
      break;
    }
  }
  const std::vector<double> all = factorsOf(best, constraints);
  if (problem.factors() != all) problem.moveTo(all, job);
  return best;
}

}  // namespace limber
