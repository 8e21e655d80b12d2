#include "linear/eigen_search.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "linear/dense/tall_product.h"

namespace limber {
namespace {

constexpr double kSafeGap = 0.01;  // relative, between eigenvalues: far more than their errors

// The index of the first pair, from the last wanted one on, that is followed by a relative gap wide enough
// for a shift that counts eigenvalues safely; if there is none, the pair before the widest gap.
Eigen::Index gapAfter(const EigenSearch& search, Eigen::Index lastWanted) {
  Eigen::Index best = lastWanted;
  double widest = -1;
  for (Eigen::Index k = lastWanted; k + 1 < search.lambda.size() && widest < kSafeGap; ++k) {
    const double gap = 1 - search.lambda[k] / search.lambda[k + 1];
    if (gap > widest) {
      widest = gap;
      best = k;
    }
  }
  return best;
}

}  // namespace

Eigen::Index zeroPairs(const EigenSearch& search, double sigma) {
  return (search.lambda.array() < kZeroRatio * std::abs(sigma)).count();
}

void inverseIterate(const ShiftedPencil& pencil, EigenSearch& search) {
  const Eigen::MatrixXd x = pencil.inverseStep(search.phi);
  const Eigen::MatrixXd h = pencil.massProduct(x, search.phi), g = pencil.massProduct(x, x);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz((h + h.transpose()) / 2,
                                                                       (g + g.transpose()) / 2);
  const Eigen::MatrixXd before = tallProduct(search.phi, ritz.eigenvectors());
  search.lambda = ritz.eigenvalues().array() + pencil.shift();
  search.phi = tallProduct(x, ritz.eigenvectors());
  search.inverseResidual = pencil.relativeChange(before, search.phi, ritz.eigenvalues());
}

int missingPairs(ShiftedPencil& pencil, const EigenSearch& search, Eigen::Index lastWanted) {
  const Eigen::Index gap = gapAfter(search, lastWanted);
  const double between = (search.lambda[gap] + search.lambda[gap + 1]) / 2;
  return static_cast<int>(pencil.countBelow(between)) - static_cast<int>(gap + 1 + search.hiddenZeros);
}

EigenSolution collectPairs(const EigenSearch& search, Eigen::Index zeros, int pairCount) {
  EigenSolution solution;
  solution.nullity = static_cast<uint32_t>(zeros + search.hiddenZeros);
  const Eigen::Index count = std::min<Eigen::Index>(pairCount, search.lambda.size() - zeros);
  solution.basis.lambda = search.lambda.segment(zeros, count);
  solution.basis.phi = search.phi.middleCols(zeros, count);
  for (Eigen::Index k = 0; k < count; ++k)
    solution.inverseResidual.push_back(search.inverseResidual[zeros + k]);
  return solution;
}

}  // namespace limber
