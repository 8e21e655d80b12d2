#include "linear/pencil.h"

#include <cmath>

#include "base/memory.h"
#include "linear/dense/dense_product.h"
#include "linear/extended_residual.h"

namespace limber {

Pencil::Pencil(const StiffnessModel& model, std::shared_ptr<const FactorStructure> structure, Job& job)
    : model_(model),
      factorisation_(structure ? Factorisation(model, std::move(structure)) : Factorisation(model, job)),
      job_(job) {
  for (Eigen::Index i = 0; i < model.mass.size(); ++i)
    if (model.mass[i] > 0) heavy_.push_back(i);
  rootMass_ = model.mass(heavy_).cwiseSqrt();
}

void Pencil::requireMemoryFor(int vectorCount) const {
  const uint64_t vectors = sizeof(double) * model_.unknownCount() * static_cast<uint64_t>(vectorCount);
  requireMemory(factorisation_.structure().memory() + vectors, "Solving this mesh as it is");
}

void Pencil::shiftTo(double sigma) {
  job_.begin(Phase::Factorise);
  factorisation_.factorise(sigma, job_);
  sigma_ = sigma;
}

uint32_t Pencil::countBelow(double lambda) {
  shiftTo(lambda);
  return factorisation_.negativePivots();
}

Eigen::VectorXd Pencil::invert(const Eigen::Ref<const Eigen::VectorXd>& x) const {
  Eigen::VectorXd full = Eigen::VectorXd::Zero(model_.mass.size());
  full(heavy_) = rootMass_.cwiseProduct(x);
  factorisation_.solve(full, job_);
  return rootMass_.cwiseProduct(full(heavy_));
}

Eigen::MatrixXd Pencil::inverseStep(const Eigen::MatrixXd& phi) const {
  Eigen::MatrixXd x = model_.mass.asDiagonal() * phi;
  factorisation_.solve(x, job_);
  return x;
}

Eigen::MatrixXd Pencil::expand(const Eigen::MatrixXd& heavy) const {
  Eigen::MatrixXd phi = Eigen::MatrixXd::Zero(model_.mass.size(), heavy.cols());
  phi(heavy_, Eigen::all) = rootMass_.cwiseInverse().asDiagonal() * heavy;
  return phi;
}

Eigen::MatrixXd Pencil::restrict(const Eigen::MatrixXd& phi) const {
  return rootMass_.asDiagonal() * phi(heavy_, Eigen::all);
}

double Pencil::residual(double lambda, const Eigen::VectorXd& phi) const {
  const Eigen::VectorXd inertia = model_.mass.cwiseProduct(phi);
  return (model_.stiffness * phi - lambda * inertia).norm() / (std::abs(lambda) * inertia.norm());
}

double Pencil::extendedResidual(double lambda, const Eigen::VectorXd& phi, int steps) const {
  Eigen::VectorXd low = Eigen::VectorXd::Zero(phi.size());
  Eigen::VectorXd rest = limber::extendedResidual(model_, lambda, phi, low);
  double smallest = rest.norm();
  for (int step = 0; step < steps; ++step) {
    factorisation_.solve(rest, job_);
    low -= rest;
    rest = limber::extendedResidual(model_, lambda, phi, low);
    if (rest.norm() >= smallest) break;
    smallest = rest.norm();
  }
  return smallest / (std::abs(lambda) * model_.mass.cwiseProduct(phi).norm());
}

Eigen::MatrixXd Pencil::massProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
  const Eigen::MatrixXd inertia = model_.mass.asDiagonal() * b;
  return product(a.transpose(), inertia);
}

}  // namespace limber
