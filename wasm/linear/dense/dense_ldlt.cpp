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
constexpr Eigen::Index kStripe = 96;     // columns or rows that one thread computes
constexpr double kTinyPivot = 1e-200;    // replaces a zero pivot, so that quotients stay finite
constexpr double kWorkForThreads = 4e6;  // multiplications of an update above which threads pay off

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
    d[j] = std::abs(a(j, j)) <= kTinyPivot ? kTinyPivot : a(j, j);  // NaN stays
    a.col(j).tail(below) /= d[j];
  }
}

// Calls update(first, count) for stripes of `size` columns or rows, on several threads if `work`
// multiplications pay for that. Each stripe is computed in the same way for any number of threads.
template <class Update>
void forEachStripe(Eigen::Index size, double work, const Update& update) {
  const auto stripes = static_cast<size_t>((size + kStripe - 1) / kStripe);
  parallelFor(stripes, work > kWorkForThreads ? 1 : stripes, [&](size_t begin, size_t end) {
    for (size_t stripe = begin; stripe < end; ++stripe) {
      const auto first = static_cast<Eigen::Index>(stripe) * kStripe;
      update(first, std::min(kStripe, size - first));
    }
  });
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
    const Eigen::Index left = pivots - next;
    const double work = static_cast<double>(left) * static_cast<double>(below) * static_cast<double>(width);
    scaled.resize(width, left);  // D L^T
    const Eigen::VectorXd inverse = d.segment(start, width).cwiseInverse();
    forEachStripe(below, work, [&](Eigen::Index first, Eigen::Index count) {
      auto rows = panel.middleRows(first, count);
      solveLower(diagonal, rows.transpose());
      const Eigen::Index pivotRows = std::min(left - first, count);
      if (pivotRows > 0) scaled.middleCols(first, pivotRows) = rows.topRows(pivotRows).transpose();
      rows *= inverse.asDiagonal();
    });
    forEachStripe(left, work, [&](Eigen::Index first, Eigen::Index count) {
      subtractLowerProduct(panel.bottomRows(below - first), scaled.middleCols(first, count),
                           columns.block(next + first, next + first, below - first, count));
    });
  }
  if (boundary == 0) return;
  const auto lower = columns.bottomRows(boundary);
  scaled.noalias() = d.asDiagonal() * lower.transpose();
  const double work = static_cast<double>(boundary) * boundary * pivots;
  forEachStripe(boundary, work, [&](Eigen::Index first, Eigen::Index count) {
    job.check();
    subtractLowerProduct(lower.bottomRows(boundary - first), scaled.middleCols(first, count),
                         update.block(first, first, boundary - first, count));
  });
}

}  // namespace limber
