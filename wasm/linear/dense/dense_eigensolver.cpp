#include "linear/dense/dense_eigensolver.h"

#include <Eigen/Dense>
#include <vector>

namespace limber {

namespace {

using Eigen::Index;

// K between some unknowns, in their order.
Eigen::MatrixXd denseStiffness(const SparsePencil& pencil, const std::vector<Index>& unknowns) {
  const auto size = static_cast<Index>(unknowns.size());
  std::vector<Index> rowOf(pencil.unknownCount(), -1);
  for (Index row = 0; row < size; ++row) rowOf[unknowns[row]] = row;
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
  for (Index column = 0; column < size; ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(pencil.k, unknowns[column]); entry; ++entry)
      if (const Index row = rowOf[entry.row()]; row >= 0) k(row, column) = entry.value();
  return k;
}

}  // namespace

ModeBasis solveDensely(const SparsePencil& pencil) {
  std::vector<Index> heavy, massless;
  for (Index i = 0; i < pencil.m.size(); ++i)
    if (pencil.m[i] > 0)
      heavy.push_back(i);
    else if (pencil.isCoupled(i))
      massless.push_back(i);
  if (heavy.empty()) return {Eigen::VectorXd(0), Eigen::MatrixXd(pencil.m.size(), 0)};
  std::vector<Index> unknowns = heavy;
  unknowns.insert(unknowns.end(), massless.begin(), massless.end());
  const Eigen::MatrixXd k = denseStiffness(pencil, unknowns);
  const auto heavyCount = static_cast<Index>(heavy.size()),
             masslessCount = static_cast<Index>(massless.size());
  Eigen::MatrixXd condensed = k.topLeftCorner(heavyCount, heavyCount), follow;
  if (!massless.empty()) {
    follow = -k.bottomRightCorner(masslessCount, masslessCount)
                  .ldlt()
                  .solve(k.bottomLeftCorner(masslessCount, heavyCount));
    condensed += k.topRightCorner(heavyCount, masslessCount) * follow;
  }
  const Eigen::VectorXd inverseRoot = pencil.m(heavy).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = inverseRoot.asDiagonal() * condensed * inverseRoot.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((scaled + scaled.transpose()) / 2);
  ModeBasis basis;
  basis.lambda = solver.eigenvalues();
  basis.phi = Eigen::MatrixXd::Zero(pencil.m.size(), basis.lambda.size());
  const Eigen::MatrixXd displacement = inverseRoot.asDiagonal() * solver.eigenvectors();
  basis.phi(heavy, Eigen::all) = displacement;
  if (!massless.empty()) basis.phi(massless, Eigen::all) = follow * displacement;
  return basis;
}

}  // namespace limber
