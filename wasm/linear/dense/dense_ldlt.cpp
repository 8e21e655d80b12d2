#include "linear/dense/dense_ldlt.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "linear/dense/dense_product.h"
#include "linear/dense/dense_triangle.h"

namespace limber {

namespace {

constexpr Eigen::Index kPanel = 32;      // columns that are eliminated at once
constexpr Eigen::Index kStripe = 96;     // columns of an update that one thread computes
constexpr double kTinyPivot = 1e-200;    // replaces a vanished pivot, so that quotients stay finite
constexpr double kWorkForThreads = 4e6;  // multiplications of an update from which threads pay

using Columns = Eigen::Map<Eigen::MatrixXd>;

// LDL^T of a small square diagonal block, column by column.
template <class Block>
void factoriseDiagonalBlock(Block a, Eigen::Ref<Eigen::VectorXd> d) {
  for (Eigen::Index j = 0; j < a.cols(); ++j) {
    const Eigen::Index below = a.rows() - j - 1;
    for (Eigen::Index k = 0; k < j; ++k) {
      const double scale = a(j, k) * d[k];
      a(j, j) -= a(j, k) * scale;
      a.col(j).tail(below) -= scale * a.col(k).tail(below);
    }
    d[j] = std::abs(a(j, j)) > kTinyPivot ? a(j, j) : kTinyPivot;
    a.col(j).tail(below) /= d[j];
  }
}

}  // namespace

void partialLdlt(Columns columns, Eigen::Ref<Eigen::VectorXd> d, Eigen::MatrixXd& update, Job& job) {
  const Eigen::Index pivots = columns.cols(), rows = columns.rows(), boundary = rows - pivots;
  Eigen::MatrixXd scaled;
  for (Eigen::Index start = 0; start < pivots; start += kPanel) {
    job.check();
    const Eigen::Index width = std::min(kPanel, pivots - start), next = start + width, below = rows - next;
    auto diagonal = columns.block(start, start, width, width);
    factoriseDiagonalBlock(diagonal, d.segment(start, width));
    auto panel = columns.block(next, start, below, width);
    solveLower(diagonal, panel.transpose());
    const Eigen::Index left = pivots - next;
    scaled = panel.topRows(left).transpose();  // D L^T
    panel *= d.segment(start, width).cwiseInverse().asDiagonal();
    for (Eigen::Index first = 0; first < left; first += kStripe) {
      const Eigen::Index count = std::min(kStripe, left - first);
      subtractProduct(panel.bottomRows(below - first), scaled.middleCols(first, count),
                      columns.block(next + first, next + first, below - first, count));
    }
  }
  if (boundary == 0) return;
  const auto lower = columns.bottomRows(boundary);
  scaled.noalias() = d.asDiagonal() * lower.transpose();
  const auto updateStripe = [&](Eigen::Index first) {
    job.check();
    const Eigen::Index count = std::min(kStripe, boundary - first);
    subtractProduct(lower.bottomRows(boundary - first), scaled.middleCols(first, count),
                    update.block(first, first, boundary - first, count));
  };
  const auto stripes = static_cast<size_t>((boundary + kStripe - 1) / kStripe);
  const double work = static_cast<double>(boundary) * boundary * pivots;
  parallelFor(stripes, work > kWorkForThreads ? 1 : stripes, [&](size_t begin, size_t end) {
    for (size_t stripe = begin; stripe < end; ++stripe)
      updateStripe(static_cast<Eigen::Index>(stripe) * kStripe);
  });
}

}  // namespace limber
