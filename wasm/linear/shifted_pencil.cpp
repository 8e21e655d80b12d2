#include "linear/shifted_pencil.h"

#include <cmath>

#include "base/parallel.h"
#include "linear/dense/tall_product.h"
#include "linear/extended_residual.h"

namespace limber {

ShiftedPencil::ShiftedPencil(const SparsePencil& pencil, std::shared_ptr<const FactorStructure> structure,
                             Job& job)
    : ShiftedPencil(pencil, factorisationOf(pencil, std::move(structure), job), job) {}

ShiftedPencil::ShiftedPencil(const SparsePencil& pencil, std::shared_ptr<Factorisation> factorisation,
                             Job& job)
    : pencil_(pencil), factorisation_(std::move(factorisation)), job_(job) {
  for (Eigen::Index i = 0; i < pencil.m.size(); ++i) {
    if (pencil.m[i] > 0)
      heavy_.push_back(i);
    else if (masslessAreZero_ && pencil.isCoupled(i))
      masslessAreZero_ = false;
  }
  rootMass_ = pencil.m(heavy_).cwiseSqrt();
}

uint64_t ShiftedPencil::memoryWith(int vectorCount) const {
  const uint64_t vectors = sizeof(double) * pencil_.unknownCount() * static_cast<uint64_t>(vectorCount);
  return factorisation_->memory() + vectors;
}

void ShiftedPencil::shiftTo(double sigma) {
  job_.begin(Phase::Factorise);
  factorisation_->factorise(sigma, job_);
  sigma_ = sigma;
}

uint32_t ShiftedPencil::countBelow(double lambda) {
  shiftTo(lambda);
  return factorisation_->negativePivots();
}

template <class Columns>
Columns ShiftedPencil::invertColumns(const Columns& x) const {
  Columns full = Columns::Zero(unknownCount(), x.cols());
  full(heavy_, Eigen::all) = rootMass_.asDiagonal() * x;
  factorisation_->solve(full, job_);
  return rootMass_.asDiagonal() * full(heavy_, Eigen::all);
}

Eigen::VectorXd ShiftedPencil::invert(const Eigen::VectorXd& x) const {
  return invertColumns(x);
}

Eigen::MatrixXd ShiftedPencil::invert(const Eigen::MatrixXd& x) const {
  return invertColumns(x);
}

Eigen::MatrixXd ShiftedPencil::inverseStep(const Eigen::MatrixXd& phi) const {
  Eigen::MatrixXd x = pencil_.m.asDiagonal() * phi;
  factorisation_->solve(x, job_);
  return x;
}

Eigen::MatrixXd ShiftedPencil::expand(const Eigen::MatrixXd& heavy) const {
  Eigen::MatrixXd phi = Eigen::MatrixXd::Zero(pencil_.m.size(), heavy.cols());
  phi(heavy_, Eigen::all) = rootMass_.cwiseInverse().asDiagonal() * heavy;
  return phi;
}

Eigen::MatrixXd ShiftedPencil::restrict(const Eigen::MatrixXd& phi) const {
  return rootMass_.asDiagonal() * phi(heavy_, Eigen::all);
}

double ShiftedPencil::residual(double lambda, const Eigen::VectorXd& phi) const {
  const Eigen::VectorXd inertia = pencil_.m.cwiseProduct(phi);
  return (pencil_.k * phi - lambda * inertia).norm() / (std::abs(lambda) * inertia.norm());
}

double ShiftedPencil::extendedResidual(double lambda, const Eigen::VectorXd& phi, int steps) const {
  Eigen::VectorXd low = Eigen::VectorXd::Zero(phi.size());
  Eigen::VectorXd rest = limber::extendedResidual(pencil_, lambda, phi, low);
  double smallest = rest.norm();
  for (int step = 0; step < steps; ++step) {
    factorisation_->solve(rest, job_);
    low -= rest;
    rest = limber::extendedResidual(pencil_, lambda, phi, low);
    if (rest.norm() >= smallest) break;
    smallest = rest.norm();
  }
  return smallest / (std::abs(lambda) * pencil_.m.cwiseProduct(phi).norm());
}

Eigen::VectorXd ShiftedPencil::relativeChange(const Eigen::MatrixXd& before, const Eigen::MatrixXd& after,
                                              const Eigen::VectorXd& scale) const {
  Eigen::VectorXd relative(before.cols());
  parallelFor(static_cast<size_t>(before.cols()), 1, [&](size_t column, size_t) {
    const auto c = static_cast<Eigen::Index>(column);
    const double change = (before.col(c) - scale[c] * after.col(c)).cwiseAbs2().dot(pencil_.m);
    relative[c] = std::sqrt(change / before.col(c).cwiseAbs2().dot(pencil_.m));
  });
  return relative;
}

Eigen::MatrixXd ShiftedPencil::massProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
  return transposedProduct(a, pencil_.m.asDiagonal() * b);
}

}  // namespace limber
