#include "fit/tune/look/implicit_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/eigen_vec3.h"

namespace limber {
namespace {

// A step ends when what is left to do is less than this fraction of the size of the motion, as the
// contraction of Newton's steps tells (Hairer and Wanner 1996, IV.8). An error of a step gives the body a
// velocity, so that errors that all point the same way sum to half the square of the number of steps: 0.5 %
// of the motion in 100 steps.
constexpr double kTolerance = 1e-6;
// What may be left to do, in the norm of energy, of a step that does not get nearer, as where a sheet
// buckles.
constexpr double kLooseTolerance = 1e-4;
// A factorisation is renewed where Newton's steps contract by less than this.
constexpr double kSlow = 0.4;
constexpr int kMostIterations = 60;
// Sufficient decrease of a line search (Nocedal and Wright 2006, ch. 3), the fraction by which it shortens a
// step, and its most shortenings.
constexpr double kDecrease = 1e-4, kShortening = 0.5;
constexpr int kMostShortenings = 20;
// Inertia is doubled at most so many times to make a second derivative positive definite.
constexpr int kMostShifts = 8;
// A step that is expected to decrease the objective by less than this fraction is not checked: differences
// as small may be rounding.
constexpr double kUnchecked = 1e-9;

// The length of the largest displacement of a vertex among unknowns. Infinite where any is not finite.
double largest(const Eigen::VectorXd& unknowns) {
  double squared = 0;
  for (Eigen::Index i = 0; i < unknowns.size(); i += 3)
    squared = std::max(squared, unknowns.segment<3>(i).squaredNorm());
  return std::isfinite(unknowns.sum()) ? std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

double inertiaOfBdf2(double step) {
  return 2.25 / (step * step);
}

}  // namespace

ImplicitMotion::ImplicitMotion(const ConstrainedBody& body, const ImplicitOptions& options, Job& job)
    : options_(options),
      system_(body, inertiaOfBdf2(options.step), job),
      factorisation_(system_.pencil(), system_.structure()),
      pinned_(body.pins.vertices),
      positions_(body.constraints.rest().begin(), body.constraints.rest().end()),
      velocities_(positions_.size()) {
  for (const uint32_t v : pinned_) pinTargets_.push_back(positions_[v]);
}

void ImplicitMotion::setVelocities(std::span<const Vec3> velocities) {
  velocities_.assign(velocities.begin(), velocities.end());
  for (const uint32_t v : pinned_) velocities_[v] = {};
}

void ImplicitMotion::setPinTargets(std::span<const Vec3> targets) {
  pinTargets_.assign(targets.begin(), targets.begin() + static_cast<std::ptrdiff_t>(pinned_.size()));
  system_.setPointTargets(targets.subspan(pinned_.size()));
}

// Backward Euler in the first step, then BDF2: x and v at the end of the step are
//   (4 x1 - x0 + 2 h v) / 3 and (4 v1 - v0 + 2 h a) / 3.
ImplicitMotion::Objective ImplicitMotion::objective() const {
  const double h = isStarted_ ? 2 * options_.step / 3 : options_.step;
  Objective objective{1 / (h * h), State(positions_.size())};
  for (size_t v = 0; v < positions_.size(); ++v) {
    const Vec3 x = isStarted_ ? (4 * positions_[v] - formerPositions_[v]) / 3 : positions_[v];
    const Vec3 velocity = isStarted_ ? (4 * velocities_[v] - formerVelocities_[v]) / 3 : velocities_[v];
    objective.aim[v] = x + h * velocity + (h * h) * options_.gravity;
  }
  return objective;
}

ImplicitMotion::State ImplicitMotion::predicted() const {
  State x(positions_.size());
  for (size_t v = 0; v < x.size(); ++v) {
    const Vec3 acceleration =
        isStarted_ ? (velocities_[v] - formerVelocities_[v]) / options_.step : options_.gravity;
    x[v] = positions_[v] + options_.step * (velocities_[v] + (0.5 * options_.step) * acceleration);
  }
  return x;
}

double ImplicitMotion::valueAt(const Objective& objective, const State& x) const {
  double inertia = 0;
  for (const uint32_t v : system_.free())
    inertia += system_.masses()[v] * squaredLength(x[v] - objective.aim[v]);
  return 0.5 * objective.inertia * inertia + system_.energyAt(x);
}

Eigen::VectorXd ImplicitMotion::inertiaForce(const Objective& objective, const State& x) const {
  Eigen::VectorXd force(system_.unknownCount());
  Eigen::Index i = 0;
  for (const uint32_t v : system_.free()) {
    force.segment<3>(i) = (objective.inertia * system_.masses()[v]) * eigen(x[v] - objective.aim[v]);
    i += 3;
  }
  return force;
}

// The derivative of the elastic energy; factorises the second derivative of the objective, with as much more
// inertia as leaves it positive definite where the body buckles.
Eigen::VectorXd ImplicitMotion::linearise(const Objective& objective, const State& x, Job& job) {
  const Eigen::VectorXd gradient = system_.linearise(x, StressKind::All);
  double inertia = objective.inertia;
  for (int i = 0; i < kMostShifts; ++i, inertia *= 2) {
    factorisation_.factorise(-inertia, job);
    ++factorisationCount_;
    if (factorisation_.negativePivots() == 0) return gradient;
  }
  system_.linearise(x, StressKind::Tension);
  factorisation_.factorise(-objective.inertia, job);
  ++factorisationCount_;
  return gradient;
}

// Moves x along the direction by the longest step that decreases the objective, whose derivative along the
// direction is `growth` <= 0. Returns the fraction of the direction, 0 where none decreases it.
double ImplicitMotion::moveAlong(const Objective& objective, const Eigen::VectorXd& direction, double growth,
                                 Point& point) const {
  double fraction = 1;
  for (int i = 0; i < kMostShortenings; ++i, fraction *= kShortening) {
    Point moved = point;
    Eigen::Index unknown = 0;
    for (const uint32_t v : system_.free()) {
      moved.x[v] += Vec3{direction[unknown], direction[unknown + 1], direction[unknown + 2]} * fraction;
      unknown += 3;
    }
    moved.value = valueAt(objective, moved.x);
    const bool isChecked = -growth > kUnchecked * point.value;
    if (!isChecked || moved.value <= point.value + kDecrease * fraction * growth) {
      point = std::move(moved);
      return fraction;
    }
  }
  return 0;
}

bool ImplicitMotion::minimise(const Objective& objective, Point& point, Job& job) {
  const double tolerance = kTolerance * options_.motionSize;
  // Steps with a factorisation of another shape may end in a long creep that looks like convergence, so that
  // each step begins with its own.
  bool renews = true;
  double former = 0;  // length of the last full step, 0 if there was none
  bool isNear = false;
  for (int i = 0; i < kMostIterations; ++i) {
    job.check();
    Eigen::VectorXd gradient = renews ? linearise(objective, point.x, job) : system_.gradientAt(point.x);
    gradient += inertiaForce(objective, point.x);
    Eigen::VectorXd direction = -gradient;
    factorisation_.solve(direction, job);
    ++solveCount_;
    const double size = largest(direction), growth = gradient.dot(direction);
    if (!std::isfinite(size) || !(growth <= 0)) return false;
    // In the norm of energy, what is left to do is a small fraction of the motion.
    const bool isLast = -growth <= kTolerance * kTolerance * point.value;
    const double fraction = moveAlong(objective, direction, growth, point);
    // Newton's own steps, with a fresh factorisation, contract well enough near the minimum.
    const double contraction = former > 0 ? size / former : 0.5;
    if (isLast || (fraction == 1 && contraction < 1 && size * contraction / (1 - contraction) <= tolerance))
      return true;
    isNear = -growth <= kLooseTolerance * kLooseTolerance * point.value;
    if (fraction == 0 && renews) return isNear || size <= tolerance;
    renews = fraction < 1 || (former > 0 && contraction > kSlow);
    former = fraction == 1 ? size : 0;
  }
  return isNear;
}

void ImplicitMotion::advanceTo(State x) {
  State velocities(x.size());
  const double h = options_.step;
  for (size_t v = 0; v < x.size(); ++v)
    velocities[v] = isStarted_ ? (3 * x[v] - 4 * positions_[v] + formerPositions_[v]) / (2 * h)
                               : (x[v] - positions_[v]) / h;
  formerPositions_ = std::exchange(positions_, std::move(x));
  formerVelocities_ = std::exchange(velocities_, std::move(velocities));
  isStarted_ = true;
}

bool ImplicitMotion::step(Job& job) {
  const Objective aim = objective();
  const auto pointAt = [&](State x) {
    for (size_t i = 0; i < pinned_.size(); ++i) x[pinned_[i]] = pinTargets_[i];
    const double value = valueAt(aim, x);
    return Point{std::move(x), value};
  };
  Point point = pointAt(predicted()), resting = pointAt(positions_);
  if (resting.value < point.value) point = std::move(resting);
  if (!minimise(aim, point, job)) return false;
  advanceTo(std::move(point.x));
  return true;
}

double ImplicitMotion::kineticEnergy() const {
  double energy = 0;
  for (size_t v = 0; v < velocities_.size(); ++v)
    energy += 0.5 * system_.masses()[v] * squaredLength(velocities_[v]);
  return energy;
}

double ImplicitMotion::potentialEnergy() const {
  double energy = 0;
  for (size_t v = 0; v < positions_.size(); ++v)
    energy -= system_.masses()[v] * dot(options_.gravity, positions_[v] - system_.constraints().rest()[v]);
  return energy;
}

}  // namespace limber
