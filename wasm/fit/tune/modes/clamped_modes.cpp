#include "fit/tune/modes/clamped_modes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "elastic/followed_modes.h"
#include "linear/eigensolver.h"
#include "transfer/shape_transfer.h"

namespace limber {
namespace {

// The modes of an original with at most this many vertices are searched from scratch, which takes little
// time; those of a larger one are refined from those of the result.
constexpr uint32_t kSearchedVertices = 3000;
constexpr int kMargin = 8;  // extra modes of the result, because the order of modes may differ

SolverVibration vibrationOf(const SolverPart& part, std::span<const double> masses,
                            const std::vector<uint32_t>& pinned) {
  return {{part.mesh, *part.stiffness, part.vertexValues(masses), pinned}, part.structure};
}

std::vector<double> ones(const SolverPart& part) {
  return std::vector<double>(part.stiffness->count(), 1.0);
}

// Calls `find`. Returns false if that does not converge.
template <typename Find>
bool converges(const Find& find) {
  try {
    find();
    return true;
  } catch (const NoConvergence&) {
    return false;
  }
}

}  // namespace

PartModesPair::PartModesPair(const PartPair& pair, const PartPins& pins, const TuneMasses& masses, int count)
    : pair_(&pair),
      pairIndex_(pins.pair),
      count_(count),
      original_(vibrationOf(pair.original, masses.original, pins.original)),
      result_(vibrationOf(pair.result, masses.result, pins.result)) {}

// Fewer zero eigenvalues than rigid motions mean that the search has missed some.
template <typename Find>
EigenSolution PartModesPair::find(int rigidMotions, const Find& find) {
  EigenSolution solution;
  const bool hasConverged = converges([&] { solution = find(); });
  const auto zeros = static_cast<int>(solution.nullity);
  if (!hasConverged || zeros < rigidMotions)
    status_ = FrequencyStatus::NoConvergence;
  else
    status_ = zeros > rigidMotions ? FrequencyStatus::NoResistance : FrequencyStatus::Found;
  return solution;
}

void PartModesPair::solveResult(double scale, Job& job) {
  if (scale <= 0) {
    const SolverVibration::Estimate estimate = result_.estimate(job);
    // No search converges among hundreds of motions without resistance.
    if (estimate.noiseCount > 0) {
      status_ = FrequencyStatus::NoResistance;
      return;
    }
    scale = estimate.firstEigenvalue;
  }
  modes_ = find(result_.rigidMotionCount(), [&] {
             return result_.solve(ones(pair_->result), count_ + kMargin, scale, job);
           }).basis;
  if (isDefinite() && modes_.modeCount() == 0) status_ = FrequencyStatus::NoConvergence;
}

EigenSolution PartModesPair::originalModes(FactorSharing& sharing, Job& job) const {
  const std::vector<double> factors = ones(pair_->original);
  if (pair_->original.mesh.vertexCount() <= kSearchedVertices)
    return original_.solve(factors, count_, firstEigenvalue(), job);
  const Eigen::Index rows = 3 * static_cast<Eigen::Index>(pair_->result.mesh.vertexCount());
  const Eigen::Index count = std::min<Eigen::Index>(modes_.modeCount(), count_ + kSpareModes);
  const ModeBasis start{modes_.lambda.head(count),
                        transfer(modes_.phi.topLeftCorner(rows, count), pair_->result.mesh, pair_->points)};
  return original_.solveFrom(start, {factors, count_, &sharing}, job);
}

void PartModesPair::solveOriginal(FactorSharing& sharing, Job& job) {
  const EigenSolution solution =
      find(original_.rigidMotionCount(), [&] { return originalModes(sharing, job); });
  if (!isDefinite()) return;
  const ModeBasis& basis = solution.basis;
  const Eigen::Index count =
      std::min({basis.modeCount(), static_cast<Eigen::Index>(count_), modes_.modeCount()});
  wanted_ = basis.lambda.head(count);
  wantedClusters_ = modeClusters(wanted_);
  Eigen::MatrixXd weighted =
      basis.phi.topLeftCorner(3 * static_cast<Eigen::Index>(pair_->original.mesh.vertexCount()), count);
  for (uint32_t v = 0; v < pair_->original.mesh.vertexCount(); ++v)
    weighted.middleRows<3>(3 * static_cast<Eigen::Index>(v)) *= original_.masses()[v];
  expected_ = pair_->carryToResult(weighted);
  match();
}

void PartModesPair::follow(std::span<const double> factors, int count, Job& job) {
  const std::vector<double> ofPart = pair_->result.constraintValues(factors);
  const int exact = std::min(count_, count + kMargin);
  ModeBasis found;
  if (!converges([&] { found = result_.follow(ofPart, modes_, exact, job); }))
    status_ = FrequencyStatus::NoConvergence;
  else if (found.modeCount() < wanted_.size())
    status_ = FrequencyStatus::NoResistance;
  else
    status_ = FrequencyStatus::Found;
  if (!isDefinite()) return;
  modes_ = std::move(found);
  match();
}

void PartModesPair::setResultMasses(std::span<const double> masses) {
  result_.setMasses(pair_->result.vertexValues(masses));
}

void PartModesPair::match() {
  const Eigen::Index rows = expected_.rows();
  partner_ = matchModes(modes_.phi.topRows(rows).transpose() * expected_, wantedClusters_);
  clusters_ = modeClusters(modes_.lambda);
}

const ModeRange& PartModesPair::clusterOf(size_t i) const {
  return *std::ranges::upper_bound(clusters_, partner_[i], {}, &ModeRange::last);
}

ClampedModes::ClampedModes(const std::deque<PartPair>& pairs, const Clamping& clamping,
                           const TuneMasses& masses, int count)
    : kind_(clamping.kind), count_(static_cast<size_t>(count)) {
  parts_.reserve(clamping.parts.size());
  for (const PartPins& pins : clamping.parts) parts_.emplace_back(pairs[pins.pair], pins, masses, count);
}

void ClampedModes::solve(std::vector<PartHints>& hints, Job& job) {
  for (PartModesPair& part : parts_) {
    PartHints& known = hints[part.pairIndex()];
    part.solveResult(known.firstEigenvalue, job);
    if (!part.isDefinite()) return;
    part.solveOriginal(known.sharing, job);
    if (!part.isDefinite()) return;
  }
  for (size_t p = 0; p < parts_.size(); ++p)
    for (Eigen::Index i = 0; i < parts_[p].wanted().size(); ++i)
      wanted_.push_back({p, static_cast<size_t>(i), parts_[p].wanted()[i]});
  std::ranges::stable_sort(wanted_, {}, &Wanted::lambda);
  wanted_.resize(std::min(wanted_.size(), count_));
}

FrequencyStatus ClampedModes::status() const {
  const auto lost = std::ranges::find_if_not(parts_, &PartModesPair::isDefinite);
  return lost == parts_.end() ? FrequencyStatus::Found : lost->status();
}

void ClampedModes::follow(std::span<const double> factors, int count, Job& job) {
  for (PartModesPair& part : parts_) part.follow(factors, count, job);
}

void ClampedModes::setResultMasses(std::span<const double> masses) {
  for (PartModesPair& part : parts_) part.setResultMasses(masses);
}

double ClampedModes::residual(size_t i) const {
  const Wanted& wanted = wanted_[i];
  return std::log(parts_[wanted.part].eigenvalue(wanted.mode) / wanted.lambda);
}

double ClampedModes::meanError(size_t first, size_t last) const {
  if (last > wanted_.size()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (size_t i = first; i < last; ++i) sum += std::abs(std::exp(0.5 * residual(i)) - 1);
  return 100 * sum / static_cast<double>(last - first);
}

}  // namespace limber
