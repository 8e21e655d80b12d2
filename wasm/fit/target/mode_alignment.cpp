#include "fit/target/mode_alignment.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "compare/assignment.h"
#include "fit/tuning.h"

namespace limber {

namespace {

namespace constants = tuning::target;

// The relative gap between two eigenvalues.
double gapOf(double a, double b) {
  return std::abs(a - b) / std::max(a, b);
}

double closeness(double a, double b) {
  return std::min(1.0, constants::kClose / gapOf(a, b));
}

bool areNear(double a, double b) {
  return gapOf(a, b) <= constants::kNear;
}

}  // namespace

AlignedModes alignModes(const Eigen::VectorXd& lambda, const Eigen::MatrixXd& overlap,
                        const Eigen::VectorXd& wanted, double thicknessWeight) {
  Eigen::MatrixXd within = overlap;
  const std::vector<int> partner = assign(overlap.transpose().cwiseAbs2());
  AlignedModes aligned;
  aligned.weight = Eigen::VectorXd::Zero(wanted.size());
  for (Eigen::Index i = 0; i < wanted.size(); ++i) {
    const int p = partner[static_cast<size_t>(i)];
    for (Eigen::Index j = 0; j < lambda.size(); ++j)
      if (p < 0 || !areNear(lambda[j], lambda[p])) within(j, i) = 0;
    const double captured = within.col(i).squaredNorm();
    aligned.weight[i] =
        thicknessWeight * (i < constants::kFirst ? 1 : constants::kLaterWeight) *
        std::clamp((captured - constants::kNoMac) / (constants::kMac - constants::kNoMac), 0.0, 1.0);
  }
  // The closest matrix with orthonormal columns (polar factor).
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(within, Eigen::ComputeThinU | Eigen::ComputeThinV);
  aligned.rotation = svd.matrixU() * svd.matrixV().transpose();
  aligned.stiffness = aligned.rotation.transpose() * lambda.asDiagonal() * aligned.rotation;
  return aligned;
}

ResidualEntries findResiduals(const AlignedModes& aligned, const Eigen::VectorXd& wanted, double coupling,
                              Mismatch& mismatch) {
  ResidualEntries found;
  std::vector<double> residuals;
  for (int i = 0; i < wanted.size(); ++i)
    for (int j = i; j < wanted.size(); ++j) {
      const double weight = std::sqrt(aligned.weight[i] * aligned.weight[j]) *
                            (i == j ? 1 : coupling * closeness(wanted[i], wanted[j]));
      if (!(weight > 0) || (i != j && !areNear(wanted[i], wanted[j]))) continue;
      const double size = std::sqrt(wanted[i] * wanted[j]);
      const double residual = aligned.stiffness(i, j) / size - (i == j);
      found.pairs.push_back({i, j, 0.5 * (aligned.stiffness(i, i) + aligned.stiffness(j, j))});
      found.scale.push_back(std::sqrt(weight) / size);
      residuals.push_back(std::sqrt(weight) * residual);
      if (i == j) mismatch.squares += weight * residual * residual;
      if (i == j) mismatch.weight += weight;
    }
  mismatch.residual =
      Eigen::Map<Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
  return found;
}

}  // namespace limber
