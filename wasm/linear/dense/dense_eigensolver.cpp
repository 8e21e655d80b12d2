#include "linear/dense/dense_eigensolver.h"

#include <Eigen/Dense>
#include <vector>

namespace limber {

DensePairs solveDensely(const StiffnessModel& model) {
  std::vector<Eigen::Index> heavy, massless;
  for (Eigen::Index i = 0; i < model.mass.size(); ++i) (model.mass[i] > 0 ? heavy : massless).push_back(i);
  const Eigen::MatrixXd k = model.stiffness;
  Eigen::MatrixXd condensed = k(heavy, heavy), follow;
  if (!massless.empty()) {
    follow = -k(massless, massless).ldlt().solve(k(massless, heavy));
    condensed += k(heavy, massless) * follow;
  }
  const Eigen::VectorXd inverseRoot = model.mass(heavy).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = inverseRoot.asDiagonal() * condensed * inverseRoot.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((scaled + scaled.transpose()) / 2);
  DensePairs pairs;
  pairs.lambda = solver.eigenvalues();
  pairs.phi = Eigen::MatrixXd::Zero(model.mass.size(), pairs.lambda.size());
  const Eigen::MatrixXd displacement = inverseRoot.asDiagonal() * solver.eigenvectors();
  pairs.phi(heavy, Eigen::all) = displacement;
  if (!massless.empty()) pairs.phi(massless, Eigen::all) = follow * displacement;
  return pairs;
}

}  // namespace limber
