#include "fit/tune/trial/swing_spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "linear/factorisation.h"
#include "mesh/eigen_vec3.h"

namespace limber {
namespace {

constexpr int kLanczosSteps = 16;
// sigma over the Rayleigh quotient of the start: far below the first frequency of any swinging body, and
// enough to factorise K of a free body.
constexpr double kShift = 1e-8;
// The smallest share of a line that counts, and the smallest omega^2 as a fraction of the energy-weighted
// median of omega^2.
constexpr double kNoticeable = 0.05, kRigid = 1e-4;

}  // namespace

std::vector<SwingLine> swingSpectrum(ImplicitSystem& system, std::span<const Vec3> velocities, Job& job) {
  system.linearise(system.constraints().rest(), StressKind::Tension);
  const SparsePencil& pencil = system.pencil();
  const Eigen::VectorXd root = pencil.m.cwiseSqrt();
  Eigen::VectorXd start(system.unknownCount());
  for (size_t i = 0; i < system.free().size(); ++i)
    start.segment<3>(3 * static_cast<Eigen::Index>(i)) = eigen(velocities[system.free()[i]]);
  const double energy = start.dot(pencil.m.cwiseProduct(start));
  if (!(energy > 0)) return {};
  const double sigma = kShift * start.dot(pencil.k * start) / energy;
  if (!(sigma > 0)) return {};
  Factorisation factorisation(pencil, system.structure());
  factorisation.factorise(-sigma, job);

  const int most = std::min<int>(kLanczosSteps, static_cast<int>(start.size()));
  Eigen::MatrixXd basis(start.size(), most), tridiagonal = Eigen::MatrixXd::Zero(most, most);
  Eigen::VectorXd next = root.cwiseProduct(start).normalized();
  int count = 0;
  for (double beta = 1; count < most && beta > 0; ++count) {
    basis.col(count) = next;
    Eigen::VectorXd inverse = root.cwiseProduct(next);
    factorisation.solve(inverse, job);
    next = root.cwiseProduct(inverse);
    tridiagonal(count, count) = next.dot(basis.col(count));
    const double before = next.norm();
    for (int pass = 0; pass < 2; ++pass)  // twice is enough (Giraud et al. 2005)
      next -= basis.leftCols(count + 1) * (basis.leftCols(count + 1).transpose() * next);
    beta = next.norm() > 1e-12 * before ? next.norm() : 0;
    if (count + 1 < most) tridiagonal(count + 1, count) = tridiagonal(count, count + 1) = beta;
    if (beta > 0) next /= beta;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(tridiagonal.topLeftCorner(count, count));
  std::vector<SwingLine> lines;
  for (int i = count; i-- > 0;) {  // the largest eigenvalues of the inverse are the lowest frequencies
    const double first = solver.eigenvectors()(0, i);
    if (solver.eigenvalues()[i] > 0)
      lines.push_back({std::max(0.0, 1 / solver.eigenvalues()[i] - sigma), first * first});
  }
  return lines;
}

Swing swingOf(std::span<const SwingLine> spectrum) {
  double sum = 0, median = 0;
  for (const SwingLine& line : spectrum) {
    sum += line.share;
    median = line.omegaSquared;
    if (sum >= 0.5) break;
  }
  Swing swing;
  double squaredSeconds = 0;
  for (const auto& [omegaSquared, share] : spectrum) {
    if (omegaSquared <= kRigid * median) continue;
    if (swing.omega == 0 && share >= kNoticeable) swing.omega = std::sqrt(omegaSquared);
    if (share >= kNoticeable) squaredSeconds += share / omegaSquared;
  }
  swing.seconds = std::sqrt(squaredSeconds);
  return swing;
}

}  // namespace limber
