#include "modes/dense_ldlt.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr Eigen::Index kPanel = 48;    // columns eliminated at once
constexpr Eigen::Index kStripe = 96;   // columns of an update given to one thread
constexpr double kTinyPivot = 1e-300;  // keeps a vanished pivot's quotient finite

using Block = Eigen::Block<Eigen::MatrixXd>;

// LDL^T of the small square block on the diagonal, column by column.
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

void partialLdlt(Eigen::MatrixXd& a, Eigen::Index pivots, Eigen::Ref<Eigen::VectorXd> d, Job& job) {
  Eigen::MatrixXd scaled;
  for (Eigen::Index start = 0; start < pivots; start += kPanel) {
    job.check();
    const Eigen::Index width = std::min(kPanel, pivots - start), next = start + width,
                       below = a.rows() - next;
    factoriseDiagonalBlock(a.block(start, start, width, width), d.segment(start, width));
    auto panel = a.block(next, start, below, width);
    a.block(start, start, width, width)
        .triangularView<Eigen::UnitLower>()
        .transpose()
        .solveInPlace<Eigen::OnTheRight>(panel);
    scaled = panel.transpose();  // D L^T
    panel *= d.segment(start, width).cwiseInverse().asDiagonal();
    const auto stripes = static_cast<size_t>((below + kStripe - 1) / kStripe);
    parallelFor(stripes, 1, [&](size_t begin, size_t end) {
      for (size_t stripe = begin; stripe < end; ++stripe) {
        const Eigen::Index first = static_cast<Eigen::Index>(stripe) * kStripe;
        const Eigen::Index columns = std::min(kStripe, below - first);
        a.block(next + first, next + first, below - first, columns).noalias() -=
            panel.bottomRows(below - first) * scaled.middleCols(first, columns);
      }
    });
  }
}

}  // namespace limber
