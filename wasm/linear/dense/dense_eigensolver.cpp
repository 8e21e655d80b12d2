#include "linear/dense/dense_eigensolver.h"

#include <Eigen/Dense>
#include <vector>

namespace limber {

ModeBasis solveDensely(const SparsePencil& pencil) {
  std::vector<Eigen::Index> heavy, massless;
  for (Eigen::Index i = 0; i < pencil.m.size(); ++i) (pencil.m[i] > 0 ? heavy : massless).push_back(i);
  if (heavy.empty()) return {Eigen::VectorXd(0), Eigen::MatrixXd(pencil.m.size(), 0)};
  const Eigen::MatrixXd k = pencil.k;
  Eigen::MatrixXd condensed = k(heavy, heavy), follow;
  if (!massless.empty()) {
    follow = -k(massless, massless).ldlt().solve(k(massless, heavy));
    condensed += k(heavy, massless) * follow;
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
