#include "fit/modal_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "linear/dense/dense_product.h"

namespace limber {

namespace {

// Rounds end once the merit falls by less than a tenth, and its root by less than this (0.1 % of frequency),
// in so many of them; brisk ones, from kFine (0.26 % of frequency) on, where the root falls by less than
// kLittleOfFine.
constexpr double kStagnant = 0.9, kLittle = 2e-3, kFine = 2.7e-5, kLittleOfFine = 2.8e-3;
constexpr size_t kPatience = 3;
constexpr double kClip = 0.1;      // of a residual, in a step
constexpr double kLeastWorth = 1;  // of a residual: see SearchLimits::mostWorth
constexpr int kHalvings = 30;      // of that range
constexpr double kLeastHold = 3e-4, kMostHold = 1e5;
// By how much the hold changes after a step that gained so much of what was foretold.
constexpr double kPoorGain = 0.3, kGoodGain = 0.7, kFullGain = 0.85;
constexpr double kFirmer = 3, kLooser = 1.5, kBriskLooser = 3;
// A vertex that the guard lets make less than this of its way is held so many times as firmly, as long as
// that goes on: the others go on without it.
constexpr double kBlocked = 0.5, kBlockedFirmer = 4, kFreedLooser = 3, kMostFirmness = 1e6;
constexpr double kEvenness = 1e-3;  // of the triangles: see SurfaceFitOptions
// What a vertex weighs that has come away from where the search began: along a flat wall nothing else holds
// it, and walls whose triangles have slid far to mend small vibrations buckle elsewhere in large ones.
constexpr double kAnchor = 1e-3;
constexpr double kLost = 1.5;  // a mesh with this much of the best merit is given up
constexpr size_t kColumnsPerRange = 16;

Eigen::VectorXd difference(const TriangleMesh& after, const TriangleMesh& before) {
  Eigen::VectorXd moved(3 * static_cast<Eigen::Index>(after.vertexCount()));
  for (uint32_t v = 0; v < after.vertexCount(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      moved[3 * static_cast<Eigen::Index>(v) + axis] = after.positions[v][axis] - before.positions[v][axis];
  return moved;
}

StepLimits withReach(StepLimits limits, const Reach& reach) {
  limits.reach = &reach;
  return limits;
}

// The lower triangle of a b, which is symmetric; the rest is 0.
Eigen::MatrixXd lowerProduct(const Eigen::Transpose<const Eigen::MatrixXd>& a,
                             const Eigen::Ref<const Eigen::MatrixXd>& b) {
  Eigen::MatrixXd negative = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  parallelFor(static_cast<size_t>(b.cols()), kColumnsPerRange, [&](size_t begin, size_t end) {
    const auto first = static_cast<Eigen::Index>(begin), count = static_cast<Eigen::Index>(end - begin),
               rows = a.rows() - first;
    subtractProduct(a.bottomRows(rows), b.middleCols(first, count),
                    negative.block(first, first, rows, count));
  });
  return -negative;
}

}  // namespace

// Minima of dx^T A dx - 2 g^T dx + worth |r + J dx|^2 for any worth, by Woodbury: J has few rows. With s =
// A^-1 g, X = A^-1 J^T, G = J X and y = (1 / worth + G)^-1 (r + J s), dx = s - X y, and the first two terms
// are y^T G y - g^T s. G is made tridiagonal once, so that each worth takes no time.
class ModalSearch::TradeOff {
 public:
  // `solved`: A^-1 times the pull and the slopes.
  TradeOff(const Eigen::VectorXd& pull, const Mismatch& mismatch, Eigen::MatrixXd solved)
      : solved_(std::move(solved)),
        gain_(pull.dot(solved_.col(0))),
        gram_(lowerProduct(mismatch.slope.transpose(), solved_.rightCols(mismatch.slope.cols()))),
        diagonal_(gram_.diagonal()),
        beside_(gram_.subDiagonal()) {
    target_ = gram_.matrixQ().adjoint() * (mismatch.residual.cwiseMax(-kClip).cwiseMin(kClip) +
                                           mismatch.slope.transpose() * solved_.col(0));
  }

  Eigen::VectorXd step(double worth) const {
    return solved_.col(0) - solved_.rightCols(target_.size()) * (gram_.matrixQ() * multipliers(worth));
  }

  // How much the surface's squared distance, over the area, would grow.
  double growth(double worth) const {
    const Eigen::VectorXd y = multipliers(worth);
    const Eigen::Index last = y.size() - 1;
    return y.cwiseAbs2().dot(diagonal_) + 2 * y.head(last).cwiseProduct(y.tail(last)).dot(beside_) - gain_;
  }

 private:
  // Solved as L D L^T.
  Eigen::VectorXd multipliers(double worth) const {
    Eigen::VectorXd pivot = diagonal_.array() + 1 / worth, y = target_;
    for (Eigen::Index k = 1; k < y.size(); ++k) {
      const double factor = beside_[k - 1] / pivot[k - 1];
      pivot[k] -= factor * beside_[k - 1];
      y[k] -= factor * y[k - 1];
    }
    y.array() /= pivot.array();
    for (Eigen::Index k = y.size() - 1; k > 0; --k) y[k - 1] -= beside_[k - 1] / pivot[k - 1] * y[k];
    return y;
  }

  Eigen::MatrixXd solved_;
  double gain_;
  Eigen::Tridiagonalization<Eigen::MatrixXd> gram_;
  Eigen::VectorXd diagonal_, beside_, target_;
};

ModalSearch::ModalSearch(const FitPart& part, const FitSamples& samples, ModalTarget& target,
                         const SearchLimits& limits, Job& job)
    : part_(part),
      samples_(samples),
      target_(target),
      limits_(limits),
      job_(job),
      topology_(buildTopology(part.simplified)),
      reach_(part.original, part.simplified, topology_),
      guard_(part.simplified, withReach(limits.steps, reach_)),
      solver_(part.locked, job),
      hold_(limits.firstHold) {
  state_.mesh = part.simplified;
  firmness_.setOnes(3 * static_cast<Eigen::Index>(part.simplified.vertexCount()));
  measure();
  before_ = state_.mismatch.meanSquare();
  best_ = state_;
}

TriangleMesh ModalSearch::run(const std::function<void(double)>& report) {
  for (int round = 0; round < limits_.mostRounds && state_.mismatch.residual.size() > 0 && !isDone();
       ++round) {
    report(static_cast<double>(round) / limits_.mostRounds);
    step();
    if (merit(state_) < merit(best_)) {
      best_ = state_;
      retreats_ = 0;
    } else if (merit(state_) > kLost * merit(best_)) {
      goBack();
    }
    merits_.push_back(merit(best_));
  }
  return best_.mesh;
}

// Little was gained since the last retreat, or a retreat could not help.
bool ModalSearch::isDone() const {
  if (hold_ >= kMostHold || merit(best_) < limits_.goodEnough) return true;
  if (merits_.size() <= kPatience) return false;
  const double was = merits_[merits_.size() - 1 - kPatience], is = merits_.back();
  const bool isFine = limits_.isBrisk && is < kFine;
  const double gained = std::sqrt(was) - std::sqrt(is);
  return (isFine && gained < kLittleOfFine) || (is > kStagnant * was && gained < kLittle);
}

void ModalSearch::measure() {
  target_.bind(state_.mesh);
  const std::vector<size_t> thicknesses = target_.thicknesses();
  std::vector<Mismatch> parts(thicknesses.size());
  // The longest comparison comes first; the fit, on which fewer threads could work together, not last.
  const auto measureOne = [&](size_t item) {
    const size_t k = item == 0 ? 0 : item - 1;
    if (item != 1)
      parts[k] = target_.compare(state_.mesh, thicknesses[k], job_);
    else
      state_.fit = fitSurface(state_.mesh, topology_, samples_,
                              {.evenness = kEvenness, .lines = &part_.lines, .near = state_.fit.touched});
  };
  parallelFor(parts.size() + 1, target_.areSideBySide() ? 1 : parts.size() + 1,
              [&](size_t begin, size_t end) {
                for (size_t item = begin; item < end; ++item) measureOne(item);
              });
  part_.flats.hold(state_.fit.stiffness);
  state_.mismatch = join(parts);
  state_.found = target_.found();
}

Eigen::VectorXd ModalSearch::gaussNewtonStep() {
  const Mismatch& mismatch = state_.mismatch;
  const SurfaceFit& fit = state_.fit;
  const Eigen::VectorXd pull =
      fit.pull - kAnchor * fit.inertia.cwiseProduct(difference(state_.mesh, part_.simplified));
  const Eigen::VectorXd inertia = fit.inertia.array() * firmness_;
  Eigen::MatrixXd columns(pull.size(), 1 + mismatch.slope.cols());
  columns << pull, mismatch.slope;
  if (part_.mirror) part_.mirror->symmetrise(columns);
  Eigen::MatrixXd solved = solver_.solve({fit.stiffness, inertia, hold_ + kAnchor}, std::move(columns));
  part_.flats.flatten(solved);
  const TradeOff tradeOff(pull, mismatch, std::move(solved));
  return tradeOff.step(affordable(tradeOff));
}

// The worth of residuals that uses up what is left of the budget.
double ModalSearch::affordable(const TradeOff& tradeOff) const {
  const double left = (limits_.budget * limits_.budget - state_.fit.meanSquare) * state_.fit.area;
  const double unit = state_.fit.area * limits_.budget * limits_.budget;
  double low = kLeastWorth * unit, high = limits_.mostWorth * unit;
  if (tradeOff.growth(high) <= left) return high;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = std::sqrt(low * high);
    (tradeOff.growth(middle) <= left ? low : high) = middle;
  }
  return low;
}

void ModalSearch::step() {
  const Mismatch was = state_.mismatch;
  const Eigen::VectorXd wanted = gaussNewtonStep();
  TriangleMesh next = guard_.apply(state_.mesh, wanted);
  if (part_.mirror) part_.mirror->symmetrise(next);
  const Eigen::VectorXd made = difference(next, state_.mesh);
  holdBlocked(wanted, made);
  const Eigen::VectorXd foretold = was.residual + was.slope.transpose() * made;
  state_.mesh = std::move(next);
  measure();
  const double gain = was.residual.squaredNorm() - state_.mismatch.residual.squaredNorm();
  const double hoped = was.residual.squaredNorm() - foretold.squaredNorm();
  if (gain < kPoorGain * hoped)
    hold_ = std::min(kMostHold, kFirmer * hold_);
  else if (gain > kGoodGain * hoped)
    hold_ =
        std::max(kLeastHold, hold_ / (limits_.isBrisk && gain > kFullGain * hoped ? kBriskLooser : kLooser));
}

void ModalSearch::holdBlocked(const Eigen::VectorXd& wanted, const Eigen::VectorXd& made) {
  for (Eigen::Index at = 0; at < wanted.size(); at += 3) {
    const bool blocked = made.segment<3>(at).norm() < kBlocked * wanted.segment<3>(at).norm();
    firmness_.segment<3>(at).setConstant(blocked ? std::min(kMostFirmness, kBlockedFirmer * firmness_[at])
                                                 : std::max(1.0, firmness_[at] / kFreedLooser));
  }
}

// Needles bend the residuals too much for a linear step: from the best mesh again, with a firmer hold; brisk
// ones with a firmer one each time that it was not enough.
void ModalSearch::goBack() {
  state_ = best_;
  target_.startFrom(state_.found);
  merits_.clear();
  const int firmer = limits_.isBrisk ? ++retreats_ : 1;
  hold_ = std::min(kMostHold, std::pow(kFirmer, 1 + firmer) * hold_);
}

double ModalSearch::merit(const State& state) const {
  const double excess = std::max(1.0, state.fit.meanSquare / (limits_.budget * limits_.budget));
  return state.mismatch.meanSquare() * excess * excess;
}

}  // namespace limber
