#include "fit/search/budgeted_step.h"

#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "fit/tuning.h"
#include "linear/dense/dense_product.h"

namespace limber {

namespace {

constexpr size_t kColumnsPerRange = 16;
constexpr int kHalvings = 30;  // of the range of weights, on a logarithmic scale

// The lower triangle of the symmetric product a b; the rest is 0.
Eigen::MatrixXd lowerProduct(const Eigen::Transpose<const Eigen::MatrixXd>& a,
                             const Eigen::Ref<const Eigen::MatrixXd>& b) {
  Eigen::MatrixXd negative = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  parallelFor(static_cast<size_t>(b.cols()), kColumnsPerRange, [&](size_t begin, size_t end) {
    const auto first = static_cast<Eigen::Index>(begin), count = static_cast<Eigen::Index>(end - begin),
               rows = a.rows() - first;
    subtractProduct(a.bottomRows(rows), b.middleCols(first, count),
                    negative.block(first, first, rows, count));
  });
  return -negative;
}

}  // namespace

BudgetedStep::BudgetedStep(const Eigen::VectorXd& gradient, const Mismatch& mismatch, Eigen::MatrixXd solved)
    : solved_(std::move(solved)),
      surfaceGain_(gradient.dot(solved_.col(0))),
      gram_(lowerProduct(mismatch.jacobian.transpose(), solved_.rightCols(mismatch.jacobian.cols()))),
      diagonal_(gram_.diagonal()),
      subdiagonal_(gram_.subDiagonal()) {
  constexpr double clip = tuning::search::kMaxResidual;
  target_ = gram_.matrixQ().adjoint() * (mismatch.residual.cwiseMax(-clip).cwiseMin(clip) +
                                         mismatch.jacobian.transpose() * solved_.col(0));
}

Eigen::VectorXd BudgetedStep::step(double residualWeight) const {
  return solved_.col(0) - solved_.rightCols(target_.size()) * (gram_.matrixQ() * multipliers(residualWeight));
}

double BudgetedStep::growth(double residualWeight) const {
  const Eigen::VectorXd y = multipliers(residualWeight);
  const Eigen::Index last = y.size() - 1;
  return y.cwiseAbs2().dot(diagonal_) + 2 * y.head(last).cwiseProduct(y.tail(last)).dot(subdiagonal_) -
         surfaceGain_;
}

double BudgetedStep::weightWithinBudget(double budget, double least, double most) const {
  if (growth(most) <= budget) return most;
  double low = least, high = most;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = std::sqrt(low * high);
    (growth(middle) <= budget ? low : high) = middle;
  }
  return low;
}

// y in the basis of Q, by an L D L^T factorisation of the tridiagonal matrix 1 / w + T.
Eigen::VectorXd BudgetedStep::multipliers(double residualWeight) const {
  Eigen::VectorXd pivot = diagonal_.array() + 1 / residualWeight, y = target_;
  for (Eigen::Index k = 1; k < y.size(); ++k) {
    const double factor = subdiagonal_[k - 1] / pivot[k - 1];
    pivot[k] -= factor * subdiagonal_[k - 1];
    y[k] -= factor * y[k - 1];
  }
  y.array() /= pivot.array();
  for (Eigen::Index k = y.size() - 1; k > 0; --k) y[k - 1] -= subdiagonal_[k - 1] / pivot[k - 1] * y[k];
  return y;
}

}  // namespace limber
