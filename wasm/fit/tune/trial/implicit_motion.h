#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tune/trial/implicit_system.h"
#include "fit/tune/trial/step_minimiser.h"

namespace limber {

struct ImplicitOptions {
  double step = 0;        // seconds, > 0
  double motionSize = 0;  // metres, > 0: the size of the motion, which the error of a step is relative to
  Vec3 gravity = {};      // m/s2
  // Of all steps together, see StepMinimiser::work.
  double mostWork = std::numeric_limits<double>::infinity();
};

// The motion of a constrained body by implicit steps. They are stable for any stiffness, and their error is
// of second order: BDF2 (Hairer and Wanner 1996, Solving Ordinary Differential Equations II, III.1 and V.1),
// after one step of backward Euler. A vibration of frequency omega keeps its amplitude but for
// 1/4 (omega h)^4 in a step of h, and its frequency but for 1/3 (omega h)^2: at 40 steps for a period it
// loses 0.6 % of amplitude and 0.8 % of frequency in one, for any mesh alike. Vibrations that are much faster
// than the step are damped away, so that what is stiff follows at rest.
//
// A step is the minimum of 1/2 |x - y|_M^2 / (2/3 h)^2 + E(x), where y is what inertia and gravity alone
// would do; see StepMinimiser. Where that does not converge, the step is made of 2, 4, 8 or 16 shorter ones,
// the first of them of backward Euler; the next step is whole again.
//
// The same input gives the same bits on any number of threads.
class ImplicitMotion {
 public:
  // At rest. The constraints of `body` must outlive it. To be constructed and advanced within a WholePhase.
  // Throws Cancelled.
  ImplicitMotion(const ConstrainedBody& body, const ImplicitOptions& options, Job& job);

  // Of all vertices, m/s, before the first step. Pinned vertices ignore theirs.
  void setVelocities(std::span<const Vec3> velocities);
  // Where the pins are to be at the end of the next step, in metres: pinned vertices, then pinned points.
  void setPinTargets(std::span<const Vec3> targets);

  // Advances by one step. False if the shortest steps did not converge either, or to nothing finite, or once
  // the most work is done; the motion must not be used any more then. Throws Cancelled.
  bool step(Job& job);

  // Of all vertices, in metres and m/s.
  std::span<const Vec3> positions() const { return now_.positions; }
  std::span<const Vec3> velocities() const { return now_.velocities; }
  // Joules.
  double kineticEnergy() const;
  double elasticEnergy() const { return system_.energyAt(now_.positions); }
  double potentialEnergy() const;

 private:
  struct Instant {
    std::vector<Vec3> positions, velocities;
  };
  // A step from `now`, and the instant as long before it; null for backward Euler.
  struct Step {
    const Instant& now;
    const Instant* former;
    double seconds;
  };

  StepObjective objectiveOf(const Step& step) const;
  std::vector<Vec3> predicted(const Step& step) const;
  std::optional<Instant> advanced(const Step& step, Job& job);
  std::optional<Instant> advancedInParts(int count, Job& job);
  void movePinsTo(double fraction);

  ImplicitOptions options_;
  ImplicitSystem system_;
  StepMinimiser minimiser_;
  std::vector<uint32_t> pinned_;
  Instant now_;
  std::optional<Instant> former_;
  // Of pinned vertices, then of pinned points: before the step, after it, and within it.
  std::vector<Vec3> pinStarts_, pinTargets_, pinPositions_;
};

}  // namespace limber
