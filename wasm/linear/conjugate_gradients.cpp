#include "linear/conjugate_gradients.h"

#include <Eigen/Dense>
#include <functional>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr double kTolerance = 1e-4;
constexpr int kMostSteps = 300;
constexpr size_t kNodesPerRange = 2048;

using Eigen::Index;
using Eigen::VectorXd;

class Solve {
 public:
  Solve(const ShiftedMatrix& matrix, Job& job) : matrix_(matrix), job_(job), inverses_(nodeCount()) {
    forRanges([&](size_t begin, size_t end) {
      for (size_t node = begin; node < end; ++node) inverses_[node] = blockOf(node).inverse();
    });
  }

  VectorXd run(const VectorXd& b) {
    VectorXd x = VectorXd::Zero(b.size()), residual = b, direction(b.size()), product(b.size());
    for (size_t node = 0; node < nodeCount(); ++node)
      if (isFixed(node)) residual.segment<3>(first(node)).setZero();
    VectorXd conditioned = precondition(residual);
    direction = conditioned;
    double square = dot(residual, conditioned);
    const double enough = kTolerance * kTolerance * square;
    for (int step = 0; step < kMostSteps && square > enough; ++step) {
      job_.check();
      multiply(direction, product);
      const double curvature = dot(direction, product);
      if (!(curvature > 0)) break;
      x += square / curvature * direction;
      residual -= square / curvature * product;
      conditioned = precondition(residual);
      const double next = dot(residual, conditioned);
      direction = conditioned + next / square * direction;
      square = next;
    }
    return x;
  }

 private:
  size_t nodeCount() const { return static_cast<size_t>(matrix_.d.size()) / 3; }
  static Index first(size_t node) { return 3 * static_cast<Index>(node); }
  bool isFixed(size_t node) const { return !matrix_.isFixed.empty() && matrix_.isFixed[node] != 0; }

  void forRanges(const std::function<void(size_t, size_t)>& body) const {
    parallelFor(nodeCount(), kNodesPerRange, body);
  }

  Eigen::Matrix3d blockOf(size_t node) const {
    Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
    for (Index c = 0; c < 3; ++c) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_.a, first(node) + c); entry; ++entry)
        if (entry.row() >= first(node) && entry.row() < first(node) + 3)
          block(entry.row() - first(node), c) = entry.value();
      block(c, c) += matrix_.mu * matrix_.d[first(node) + c];
    }
    return block;
  }

  // Columns stand for rows, for the matrix is symmetric.
  void multiply(const VectorXd& x, VectorXd& product) const {
    forRanges([&](size_t begin, size_t end) {
      for (size_t node = begin; node < end; ++node)
        for (Index row = first(node); row < first(node) + 3; ++row) {
          double sum = matrix_.mu * matrix_.d[row] * x[row];
          for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_.a, row); entry; ++entry)
            sum += entry.value() * x[entry.row()];
          product[row] = isFixed(node) ? 0 : sum;
        }
    });
  }

  VectorXd precondition(const VectorXd& residual) const {
    VectorXd conditioned(residual.size());
    forRanges([&](size_t begin, size_t end) {
      for (size_t node = begin; node < end; ++node)
        conditioned.segment<3>(first(node)) = inverses_[node] * residual.segment<3>(first(node));
    });
    return conditioned;
  }

  // Summed range by range, in order, so that it does not depend on threads.
  double dot(const VectorXd& x, const VectorXd& y) const {
    std::vector<double> sums((nodeCount() + kNodesPerRange - 1) / kNodesPerRange);
    forRanges([&](size_t begin, size_t end) {
      const auto count = 3 * static_cast<Index>(end - begin);
      sums[begin / kNodesPerRange] = x.segment(first(begin), count).dot(y.segment(first(begin), count));
    });
    double sum = 0;
    for (const double own : sums) sum += own;
    return sum;
  }

  const ShiftedMatrix& matrix_;
  Job& job_;
  std::vector<Eigen::Matrix3d> inverses_;
};

}  // namespace

VectorXd conjugateGradients(const ShiftedMatrix& matrix, const VectorXd& b, Job& job) {
  return Solve(matrix, job).run(b);
}

}  // namespace limber
