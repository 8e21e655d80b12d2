#include "fit/tune/steps/tune_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limber {
namespace {

// The first eigenvalue of a beam clamped at one end over that of a free one is (1.875 / 4.730)^4 = 0.025;
// only used to start the search for clamped modes.
constexpr double kClampedOverFree = 0.03;
constexpr double kNoError = std::numeric_limits<double>::quiet_NaN();

int wantedModes(ClampKind kind) {
  switch (kind) {
    case ClampKind::Free:
      return 30;
    case ClampKind::LowerEnd:
      return 8;
    default:
      return 10;
  }
}

size_t fittedModes(const ClampedModes& clamping) {
  const size_t count = clamping.wanted().size();
  if (clamping.kind() == ClampKind::OtherEnd) return 0;
  return clamping.kind() == ClampKind::Free ? std::min<size_t>(count, 20) : count;
}

// The derivatives of the logarithms of the eigenvalues of a part's result with respect to the logarithms of
// its factors: constraints x modes 0 .. count - 1.
Eigen::MatrixXd shares(const PartModesPair& part, const Eigen::VectorXd& factors, Eigen::Index count) {
  const ModeBasis& modes = part.modes();
  Eigen::MatrixXd shares = part.pair().result.stiffness->energies(modes.phi.leftCols(count));
  shares.array().colwise() *= factors.array();
  shares.array().rowwise() /= modes.lambda.head(count).transpose().array();
  return shares;
}

// Adds rows to the Jacobian for the fitted modes of a clamping, from row `first` on.
void fillRows(const ClampedModes& clamping, const std::vector<double>& factors, Eigen::Index first,
              Eigen::MatrixXd& jacobian) {
  for (size_t p = 0; p < clamping.parts().size(); ++p) {
    const PartModesPair& part = clamping.parts()[p];
    std::vector<size_t> rows;
    Eigen::Index count = 0;  // of modes that the rows need
    for (size_t i = 0; i < fittedModes(clamping); ++i) {
      if (clamping.wanted()[i].part != p) continue;
      rows.push_back(i);
      count = std::max(count, part.clusterOf(clamping.wanted()[i].mode).last);
    }
    if (rows.empty()) continue;
    const std::vector<uint32_t>& constraints = part.pair().result.constraints;
    const std::vector<double> ofPart = part.pair().result.constraintValues(factors);
    const Eigen::MatrixXd all = shares(
        part, Eigen::Map<const Eigen::VectorXd>(ofPart.data(), static_cast<Eigen::Index>(ofPart.size())),
        count);
    for (const size_t row : rows) {
      const ModeRange& cluster = part.clusterOf(clamping.wanted()[row].mode);
      const Eigen::VectorXd mean =
          all.middleCols(cluster.first, cluster.last - cluster.first).rowwise().mean();
      for (size_t c = 0; c < constraints.size(); ++c)
        jacobian(first + static_cast<Eigen::Index>(row), constraints[c]) = mean[static_cast<Eigen::Index>(c)];
    }
  }
}

// The error of the first ten modes at other factors; NaN if these leave motions without resistance.
double followedError(ClampedModes modes, const std::vector<double>& factors, Job& job) {
  modes.follow(factors, kJudgedModes, job);
  return modes.isDefinite() ? modes.meanError(0, kJudgedModes) : kNoError;
}

}  // namespace

TuneProblem::TuneProblem(const TuneSetup& setup, Job& job) : factors_(setup.constraintCount, 1.0) {
  std::vector<PartHints> hints(setup.pairs.size());
  for (const Clamping& clamping : setup.clampings) {
    clampings_.emplace_back(setup.pairs, clamping, setup.masses, wantedModes(clamping.kind));
    if (clamping.kind == ClampKind::Free) continue;
    for (const PartModesPair& part : clampings_.back().parts())
      hints[part.pairIndex()].sharing.unknowns.push_back(part.clampedUnknowns());
  }
  for (ClampedModes& modes : clampings_) {
    modes.solve(hints, job);
    if (!modes.isDefinite()) return;
    if (modes.kind() != ClampKind::Free) continue;
    for (const PartModesPair& part : modes.parts())
      hints[part.pairIndex()].firstEigenvalue = kClampedOverFree * part.firstEigenvalue();
  }
}

FrequencyStatus TuneProblem::status() const {
  const auto lost = std::ranges::find_if_not(clampings_, &ClampedModes::isDefinite);
  return lost == clampings_.end() ? FrequencyStatus::Found : lost->status();
}

void TuneProblem::moveTo(const std::vector<double>& factors, Job& job) {
  factors_ = factors;
  for (ClampedModes& clamping : clampings_)
    if (clamping.kind() != ClampKind::OtherEnd) clamping.follow(factors_, job);
}

Eigen::VectorXd TuneProblem::residuals() const {
  std::vector<double> residuals;
  for (const ClampedModes& clamping : clampings_)
    for (size_t i = 0; i < fittedModes(clamping); ++i) residuals.push_back(clamping.residual(i));
  return Eigen::Map<Eigen::VectorXd>(residuals.data(), static_cast<Eigen::Index>(residuals.size()));
}

Eigen::MatrixXd TuneProblem::jacobian() const {
  size_t count = 0;
  for (const ClampedModes& clamping : clampings_) count += fittedModes(clamping);
  Eigen::MatrixXd jacobian =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(factors_.size()));
  Eigen::Index first = 0;
  for (const ClampedModes& clamping : clampings_) {
    fillRows(clamping, factors_, first, jacobian);
    first += static_cast<Eigen::Index>(fittedModes(clamping));
  }
  return jacobian;
}

double TuneProblem::fittedError() const {
  const Eigen::VectorXd residual = residuals();
  return 100 * ((0.5 * residual.array()).exp() - 1).abs().mean();
}

double TuneProblem::otherPinsError(Job& job) const {
  const auto other = std::ranges::find(clampings_, ClampKind::OtherEnd, &ClampedModes::kind);
  return other == clampings_.end() ? kNoError : followedError(*other, factors_, job);
}

double TuneProblem::freeErrorWith(std::span<const double> masses, Job& job) const {
  ClampedModes free = clampings_[0];
  free.setResultMasses(masses);
  return followedError(std::move(free), std::vector<double>(factors_.size(), 1.0), job);
}

}  // namespace limber
