#include "fit/tune/trial/implicit_motion.h"

#include <utility>

namespace limber {
namespace {

// A step is divided into at most this many.
constexpr int kMaxParts = 16;

double inertiaOfBdf2(double step) {
  return 2.25 / (step * step);
}

}  // namespace

ImplicitMotion::ImplicitMotion(const ConstrainedBody& body, const ImplicitOptions& options, Job& job)
    : options_(options),
      system_(body, inertiaOfBdf2(options.step), job),
      minimiser_(system_, options.motionSize, options.mostWork),
      pinned_(body.pins.vertices) {
  const std::span<const Vec3> rest = body.constraints.rest();
  now_.positions.assign(rest.begin(), rest.end());
  now_.velocities.resize(rest.size());
  for (const uint32_t v : pinned_) pinStarts_.push_back(rest[v]);
  for (const SurfacePoint& point : body.pins.points)
    pinStarts_.push_back(positionOf(point, body.mesh.triangles, rest));
  pinTargets_ = pinPositions_ = pinStarts_;
}

void ImplicitMotion::setVelocities(std::span<const Vec3> velocities) {
  now_.velocities.assign(velocities.begin(), velocities.end());
  for (const uint32_t v : pinned_) now_.velocities[v] = {};
}

void ImplicitMotion::setPinTargets(std::span<const Vec3> targets) {
  pinTargets_.assign(targets.begin(), targets.end());
}

// Within the step: 1 at its end.
void ImplicitMotion::movePinsTo(double fraction) {
  for (size_t i = 0; i < pinTargets_.size(); ++i)
    pinPositions_[i] =
        fraction == 1 ? pinTargets_[i] : pinStarts_[i] + fraction * (pinTargets_[i] - pinStarts_[i]);
  system_.setPointTargets(std::span<const Vec3>(pinPositions_).subspan(pinned_.size()));
}

// BDF2: x and v at the end of the step are
//   (4 x1 - x0 + 2 h v) / 3 and (4 v1 - v0 + 2 h a) / 3.
StepObjective ImplicitMotion::objectiveOf(const Step& step) const {
  const auto& [now, former, seconds] = step;
  const double h = former ? 2 * seconds / 3 : seconds;
  const auto before = [&](const std::vector<Vec3>& at, const std::vector<Vec3>& past, size_t v) {
    return (4 * at[v] - past[v]) / 3;
  };
  StepObjective objective{1 / (h * h), std::vector<Vec3>(now.positions.size())};
  for (size_t v = 0; v < now.positions.size(); ++v) {
    const Vec3 x = former ? before(now.positions, former->positions, v) : now.positions[v];
    const Vec3 velocity = former ? before(now.velocities, former->velocities, v) : now.velocities[v];
    objective.aim[v] = x + h * velocity + (h * h) * options_.gravity;
  }
  return objective;
}

std::vector<Vec3> ImplicitMotion::predicted(const Step& step) const {
  const auto& [now, former, seconds] = step;
  std::vector<Vec3> x(now.positions.size());
  for (size_t v = 0; v < x.size(); ++v) {
    const Vec3 acceleration =
        former ? (now.velocities[v] - former->velocities[v]) / seconds : options_.gravity;
    x[v] = now.positions[v] + seconds * (now.velocities[v] + (0.5 * seconds) * acceleration);
  }
  return x;
}

std::optional<ImplicitMotion::Instant> ImplicitMotion::advanced(const Step& step, Job& job) {
  const StepObjective objective = objectiveOf(step);
  const auto pinned = [&](std::vector<Vec3> x) {
    for (size_t i = 0; i < pinned_.size(); ++i) x[pinned_[i]] = pinPositions_[i];
    return x;
  };
  std::vector<Vec3> x = pinned(predicted(step)), resting = pinned(step.now.positions);
  if (minimiser_.valueAt(objective, resting) < minimiser_.valueAt(objective, x)) x = std::move(resting);
  if (!minimiser_.minimise(objective, x, job)) return std::nullopt;
  const auto& [now, former, seconds] = step;
  std::vector<Vec3> velocities(x.size());
  for (size_t v = 0; v < x.size(); ++v)
    velocities[v] = former ? (3 * x[v] - 4 * now.positions[v] + former->positions[v]) / (2 * seconds)
                           : (x[v] - now.positions[v]) / seconds;
  return Instant{std::move(x), std::move(velocities)};
}

std::optional<ImplicitMotion::Instant> ImplicitMotion::advancedInParts(int count, Job& job) {
  Instant now = now_;
  std::optional<Instant> former;
  for (int part = 1; part <= count; ++part) {
    movePinsTo(static_cast<double>(part) / count);
    std::optional<Instant> next = advanced({now, former ? &*former : nullptr, options_.step / count}, job);
    if (!next) return std::nullopt;
    former = std::exchange(now, std::move(*next));
  }
  return now;
}

bool ImplicitMotion::step(Job& job) {
  movePinsTo(1);
  std::optional<Instant> next = advanced({now_, former_ ? &*former_ : nullptr, options_.step}, job);
  for (int parts = 2; !next && parts <= kMaxParts; parts *= 2) next = advancedInParts(parts, job);
  if (!next) return false;
  former_ = std::exchange(now_, std::move(*next));
  pinStarts_ = pinTargets_;
  return true;
}

double ImplicitMotion::kineticEnergy() const {
  double energy = 0;
  for (size_t v = 0; v < now_.velocities.size(); ++v)
    energy += 0.5 * system_.masses()[v] * squaredLength(now_.velocities[v]);
  return energy;
}

double ImplicitMotion::potentialEnergy() const {
  double energy = 0;
  for (size_t v = 0; v < now_.positions.size(); ++v)
    energy -=
        system_.masses()[v] * dot(options_.gravity, now_.positions[v] - system_.constraints().rest()[v]);
  return energy;
}

}  // namespace limber
