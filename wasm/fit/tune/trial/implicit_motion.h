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
  double motionSize = 0;  // metres, > 0: the size of the motion, to which the error of a step is relative
  Vec3 gravity = {};      // m/s2
  // Limit for all steps together, see StepMinimiser::work.
  double mostWork = std::numeric_limits<double>::infinity();
};

// The motion of a constrained body by implicit time steps, which are stable for any stiffness and
// second-order accurate: BDF2 (Hairer and Wanner 1996, Solving Ordinary Differential Equations II, III.1 and
// V.1), after one step of backward Euler. In a step of h, a vibration of frequency omega loses 1/4 (omega
// h)^4 of its amplitude and 1/3 (omega h)^2 of its frequency: at 40 steps per period 0.6 % of amplitude and
// 0.8 % of frequency per period, the same for any mesh. Vibrations that are much faster than the step are
// damped out, so that stiff parts follow quasi-statically.
//
// A step is the minimum of 1/2 |x - y|_M^2 / (2/3 h)^2 + E(x), where y is the motion under inertia and
// gravity alone; see StepMinimiser. If that does not converge, the step is split into 2, 4, 8 or 16 shorter
// ones, the first of them of backward Euler; the next step has full length again.
//
// The same input gives the same bits on any number of threads.
class ImplicitMotion {
 public:
  // Starts at rest. The constraints of `body` must outlive it. Must be constructed and advanced within a
  // WholePhase. Throws Cancelled.
  ImplicitMotion(const ConstrainedBody& body, const ImplicitOptions& options, Job& job);

  // Sets the velocities of all vertices, in m/s, before the first step. Pinned vertices ignore theirs.
  void setVelocities(std::span<const Vec3> velocities);
  // Sets the positions of the pins at the end of the next step, in metres: pinned vertices, then pinned
  // points.
  void setPinTargets(std::span<const Vec3> targets);

  // Advances by one step. Returns false if even the shortest steps did not converge to finite values, or once
  // the work limit is reached; the motion must not be used afterwards. Throws Cancelled.
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
  // A step from `now`; `before` is the state one step length earlier, or null for backward Euler.
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
  // Positions of pinned vertices, then of pinned points: before the step, after it, and within it.
  std::vector<Vec3> pinStarts_, pinTargets_, pinPositions_;
};

}  // namespace limber
