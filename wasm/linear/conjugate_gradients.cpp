#include "linear/conjugate_gradients.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "base/parallel.h"

namespace limber {

namespace {

// The tolerance of an inexact Gauss-Newton step (Dembo, Eisenstat and Steihaug 1982): the next step has a
// different model, so more digits of this one would be wasted. Fits are equally good from 1e-4 to 3e-2.
constexpr double kTolerance = 1e-2;
constexpr int kMaxSteps = 300;
constexpr size_t kNodesPerRange = 2048;
constexpr Eigen::Index kMaxColumns = 3;

using Eigen::Index;
using Eigen::MatrixXd;

template <class Body>
void forNodes(size_t count, const Body& body) {
  parallelFor(count, kNodesPerRange, [&](size_t begin, size_t end) {
    for (size_t node = begin; node < end; ++node) body(node);
  });
}

// Solves for K columns together. The unknowns of a node in all columns are contiguous, as a 3 x K matrix.
template <int K>
class Solve {
 public:
  using Unknowns = Eigen::Matrix<double, 3, K>;
  using Vector = std::vector<Unknowns>;
  using Numbers = Eigen::Array<double, 1, K>;  // one for each column

  Solve(const ShiftedMatrix& matrix, Job& job)
      : matrix_(matrix),
        job_(job),
        inverses_(matrix.a.nodeCount()),
        rangeSums_((matrix.a.nodeCount() + kNodesPerRange - 1) / kNodesPerRange) {
    forNodes(matrix.a.nodeCount(), [&](size_t node) {
      const auto i = static_cast<uint32_t>(node);
      Eigen::Matrix3d block = matrix_.a.at(i, i);
      block.diagonal() += matrix_.mu * dampingOf(node);
      inverses_[node] = block.inverse();
    });
  }

  Vector run(Vector residual) {
    Vector x(residual.size(), Unknowns::Zero()), direction(residual.size(), Unknowns::Zero()),
        product(residual.size());
    Numbers squares = sumOver([&](size_t node) -> Numbers {
      if (isFixed(node)) residual[node].setZero();
      return dot(residual[node], inverses_[node] * residual[node]);
    });
    const Numbers enough = kTolerance * kTolerance * squares;
    Numbers ratio = Numbers::Zero();
    for (int step = 0; step < kMaxSteps && (squares > enough).any(); ++step) {
      job_.check();
      conjugate(direction, residual, ratio);
      const Numbers curvature = multiply(direction, product);
      if (!((curvature > 0) || (squares <= enough)).all()) break;
      // A column that has converged does not change.
      const Numbers length = (squares > enough).select(squares / curvature, 0);
      const Numbers next = sumOver([&](size_t node) -> Numbers {
        x[node].array() += direction[node].array().rowwise() * length;
        residual[node].array() -= product[node].array().rowwise() * length;
        return dot(residual[node], inverses_[node] * residual[node]);
      });
      ratio = (squares > 0).select(next / squares, 0);
      squares = next;
    }
    return x;
  }

 private:
  static Numbers dot(const Unknowns& x, const Unknowns& y) {
    return x.cwiseProduct(y).colwise().sum().array();
  }
  auto dampingOf(size_t node) const { return matrix_.d.segment<3>(3 * static_cast<Index>(node)); }
  bool isFixed(size_t node) const { return !matrix_.isFixed.empty() && matrix_.isFixed[node] != 0; }

  // The sums of part(node), range by range in order, so that they do not depend on threads.
  template <class Part>
  Numbers sumOver(const Part& part) {
    parallelFor(matrix_.a.nodeCount(), kNodesPerRange, [&](size_t begin, size_t end) {
      Numbers sum = Numbers::Zero();
      for (size_t node = begin; node < end; ++node) sum += part(node);
      rangeSums_[begin / kNodesPerRange] = sum;
    });
    Numbers sum = Numbers::Zero();
    for (const Numbers& own : rangeSums_) sum += own;
    return sum;
  }

  // The next direction: the preconditioned residual, conjugate to the last direction.
  void conjugate(Vector& direction, const Vector& residual, const Numbers& ratio) const {
    forNodes(direction.size(), [&](size_t node) {
      direction[node] =
          (inverses_[node] * residual[node]).array() + direction[node].array().rowwise() * ratio;
    });
  }

  // product = (A + mu D) x; returns x . product.
  Numbers multiply(const Vector& x, Vector& product) {
    const BlockMatrix& a = matrix_.a;
    return sumOver([&](size_t node) -> Numbers {
      Unknowns sum = (matrix_.mu * dampingOf(node)).asDiagonal() * x[node];
      for (uint32_t k = a.start[node]; k < a.start[node + 1]; ++k)
        sum.noalias() += a.blocks[k] * x[a.column[k]];
      if (isFixed(node)) sum.setZero();
      product[node] = sum;
      return dot(x[node], sum);
    });
  }

  const ShiftedMatrix& matrix_;
  Job& job_;
  std::vector<Eigen::Matrix3d> inverses_;
  std::vector<Numbers> rangeSums_;  // scratch
};

template <int K>
void solveColumns(const ShiftedMatrix& matrix, Index first, MatrixXd& columns, Job& job) {
  typename Solve<K>::Vector unknowns(matrix.a.nodeCount());
  forNodes(unknowns.size(),
           [&](size_t node) { unknowns[node] = columns.block<3, K>(3 * static_cast<Index>(node), first); });
  unknowns = Solve<K>(matrix, job).run(std::move(unknowns));
  forNodes(unknowns.size(),
           [&](size_t node) { columns.block<3, K>(3 * static_cast<Index>(node), first) = unknowns[node]; });
}

}  // namespace

MatrixXd conjugateGradients(const ShiftedMatrix& matrix, const MatrixXd& b, Job& job) {
  MatrixXd columns = b;
  for (Index first = 0; first < columns.cols(); first += kMaxColumns) {
    const Index count = std::min(kMaxColumns, columns.cols() - first);
    if (count == 1) solveColumns<1>(matrix, first, columns, job);
    if (count == 2) solveColumns<2>(matrix, first, columns, job);
    if (count == 3) solveColumns<3>(matrix, first, columns, job);
  }
  return columns;
}

}  // namespace limber
