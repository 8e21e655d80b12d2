#include "fit/tune/trial/step_minimiser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "mesh/eigen_vec3.h"

namespace limber {
namespace {

// A step ends when the estimated remaining error is less than this fraction of the size of the motion; the
// estimate comes from the contraction of the Newton steps (Hairer and Wanner 1996, IV.8). An error of a step
// gives the body a velocity, so that errors of the same sign grow with half the square of the number of
// steps: to 0.5 % of the motion in 100 steps.
constexpr double kTolerance = 1e-6;
// The accepted remaining error, in the energy norm, of a step that no longer improves, for example when a
// sheet buckles.
constexpr double kLooseTolerance = 1e-4;
// The Newton equations are solved until the preconditioned residual has shrunk by this factor, which is then
// the contraction of the Newton steps.
constexpr double kForcing = 0.01;
// If Newton steps with a factorisation of an earlier time step contract by less than this, it is renewed.
constexpr double kSlow = 0.1;
constexpr int kMaxIterations = 60;
// Sufficient decrease of a line search (Nocedal and Wright 2006, ch. 3), the fraction by which it shortens a
// step, and its most shortenings.
constexpr double kDecrease = 1e-4, kShortening = 0.5;
constexpr int kMaxShortenings = 20;
// A step that is expected to decrease the objective by less than this fraction is not checked: such small
// differences may be rounding errors.
constexpr double kUnchecked = 1e-9;
// How many times as many multiplications per second a factorisation of dense fronts does as a solve, which
// waits for memory.
constexpr double kDenseSpeed = 4;
// Solves that are needed even with a fresh factorisation.
constexpr int kFreeSolves = 3;
constexpr int kMinSolves = 20;       // before conjugate gradients give up
constexpr double kOtherInertia = 2;  // ratio above which a factorisation is renewed
constexpr size_t kGrain = 1024;      // columns that a thread takes at once

// The length of the largest displacement of a vertex among unknowns. Infinite if any is not finite.
double largest(const Eigen::VectorXd& unknowns) {
  double squared = 0;
  for (Eigen::Index i = 0; i < unknowns.size(); i += 3)
    squared = std::max(squared, unknowns.segment<3>(i).squaredNorm());
  return std::isfinite(unknowns.sum()) ? std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

double solveWorkOf(const FactorStructure& structure) {
  return 2.0 * static_cast<double>(std::max<uint64_t>(1, structure.valueCount));
}

}  // namespace

StepMinimiser::StepMinimiser(ImplicitSystem& system, double motionSize, double mostWork)
    : system_(system),
      factorisation_(system.pencil(), system.structure()),
      motionSize_(motionSize),
      mostWork_(mostWork),
      solveWork_(solveWorkOf(*system.structure())),
      price_(std::max(1.0, system.structure()->work() / (kDenseSpeed * solveWork_))) {}

double StepMinimiser::valueAt(const StepObjective& objective, const State& x) const {
  double inertia = 0;
  for (const uint32_t v : system_.free())
    inertia += system_.masses()[v] * squaredLength(x[v] - objective.aim[v]);
  return 0.5 * objective.inertia * inertia + system_.energyAt(x);
}

void StepMinimiser::factorise(double inertia, const State& x, Job& job) {
  system_.linearise(x, StressKind::Tension);
  factorisation_.factorise(-inertia, job);
  ++factorisationCount_;
  factorInertia_ = inertia;
  rent_ = 0;
}

// The derivative of the objective; K of the system becomes the second derivative of the elastic energy.
Eigen::VectorXd StepMinimiser::linearise(const StepObjective& objective, const State& x, Job& job) {
  const double ratio = objective.inertia / factorInertia_;
  isFresh_ = renews_ || !(ratio < kOtherInertia && ratio > 1 / kOtherInertia);
  if (isFresh_) factorise(objective.inertia, x, job);
  renews_ = false;
  Eigen::VectorXd gradient = system_.linearise(x, StressKind::All);
  Eigen::Index i = 0;
  for (const uint32_t v : system_.free()) {
    gradient.segment<3>(i) += (objective.inertia * system_.masses()[v]) * eigen(x[v] - objective.aim[v]);
    i += 3;
  }
  return gradient;
}

// (K + inertia M) x, by columns of the symmetric K.
Eigen::VectorXd StepMinimiser::product(const Eigen::VectorXd& x, double inertia) const {
  const SparsePencil& pencil = system_.pencil();
  Eigen::VectorXd result(x.size());
  const int* starts = pencil.k.outerIndexPtr();
  const int* rows = pencil.k.innerIndexPtr();
  const double* values = pencil.k.valuePtr();
  parallelFor(static_cast<size_t>(x.size()), kGrain, [&](size_t begin, size_t end) {
    for (size_t column = begin; column < end; ++column) {
      const auto u = static_cast<Eigen::Index>(column);
      double sum = inertia * pencil.m[u] * x[u];
      for (int entry = starts[column]; entry < starts[column + 1]; ++entry)
        sum += values[entry] * x[rows[entry]];
      result[u] = sum;
    }
  });
  return result;
}

// Always a descent direction: conjugate gradients start at 0.
Eigen::VectorXd StepMinimiser::newtonDirection(const Eigen::VectorXd& gradient, double inertia, Job& job) {
  const auto preconditioned = [&](Eigen::VectorXd residual) {
    factorisation_.solve(residual, job);
    ++solveCount_;
    return residual;
  };
  const int most = std::max(kMinSolves, static_cast<int>(price_));
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(gradient.size()), residual = -gradient;
  Eigen::VectorXd towards = preconditioned(residual), search = towards;
  double size = residual.dot(towards);
  const double enough = kForcing * kForcing * size;
  int solves = 1;
  for (; solves <= most; ++solves) {
    const Eigen::VectorXd image = product(search, inertia);
    const double curvature = search.dot(image);
    if (!(curvature > 0)) {
      renews_ = renews_ || !isFresh_;
      return solves == 1 ? search : direction;
    }
    const double length = size / curvature;
    direction += length * search;
    residual -= length * image;
    towards = preconditioned(residual);
    const double former = std::exchange(size, residual.dot(towards));
    if (!(size > enough)) break;
    search = towards + (size / former) * search;
  }
  rent_ += std::max(0, solves - kFreeSolves);
  renews_ = renews_ || rent_ >= price_ || solves > most;
  return direction;
}

// Moves x along the direction by the longest step that decreases the objective, whose derivative along the
// direction is `growth` <= 0. Returns the fraction of the direction, 0 if none decreases it.
double StepMinimiser::moveAlong(const StepObjective& objective, const Eigen::VectorXd& direction,
                                double growth, Point& point) const {
  double fraction = 1;
  for (int i = 0; i < kMaxShortenings; ++i, fraction *= kShortening) {
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

bool StepMinimiser::minimise(const StepObjective& objective, State& x, Job& job) {
  const double tolerance = kTolerance * motionSize_;
  Point point{x, valueAt(objective, x)};
  double former = 0;                   // length of the last full step, 0 if there was none
  bool isNear = false, isOwn = false;  // isOwn: the factorisation was made in this step
  for (int i = 0; i < kMaxIterations; ++i) {
    job.check();
    if (work() > mostWork_) return false;
    const Eigen::VectorXd gradient = linearise(objective, point.x, job);
    const Eigen::VectorXd direction = newtonDirection(gradient, objective.inertia, job);
    const double size = largest(direction), growth = gradient.dot(direction);
    if (!std::isfinite(size) || !(growth <= 0)) return false;
    // The remaining error is a small fraction of the motion in the energy norm.
    const bool isSmall = -growth <= kTolerance * kTolerance * point.value;
    const double fraction = moveAlong(objective, direction, growth, point);
    x = point.x;
    // If a stiff part has rotated since, an old factorisation leaves soft components to later iterations: the
    // first iteration then says nothing about convergence, and slow ones may end in a creep that looks like
    // convergence.
    isOwn = isOwn || isFresh_;
    const bool isTold = i > 0 || isFresh_;
    const double contraction = former > 0 ? size / former : 0.5;
    const bool isLast =
        fraction == 1 && contraction < 1 && size * contraction / (1 - contraction) <= tolerance;
    if (isTold && (isSmall || isLast)) return true;
    isNear = -growth <= kLooseTolerance * kLooseTolerance * point.value;
    if (fraction == 0 && isFresh_) return isNear || size <= tolerance;
    renews_ = renews_ || fraction == 0 || (!isOwn && i > 0 && contraction > kSlow);
    former = fraction == 1 ? size : 0;
  }
  return isNear;
}

}  // namespace limber
