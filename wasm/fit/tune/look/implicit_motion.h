#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tune/look/implicit_system.h"
#include "linear/factorisation.h"

namespace limber {

struct ImplicitOptions {
  double step = 0;        // seconds, > 0
  double motionSize = 0;  // metres, > 0: the size of the motion, which the error of a step is relative to
  Vec3 gravity = {};      // m/s2
};

// The motion of a constrained body by implicit steps. They are stable for any stiffness, and their error is
// of second order: BDF2 (Hairer and Wanner 1996, Solving Ordinary Differential Equations II, III.1 and V.1),
// after one step of backward Euler. A vibration of frequency omega keeps its amplitude but for
// 1/4 (omega h)^4 in a step of h, and its frequency but for 1/3 (omega h)^2: at 40 steps for a period it
// loses 0.6 % of amplitude and 0.8 % of frequency in one, for any mesh alike. Vibrations that are much faster
// than the step are damped away, so that what is stiff follows at rest.
//
// A step is the minimum of 1/2 |x - y|_M^2 / (2/3 h)^2 + E(x), where y is what inertia and gravity alone
// would do. It is found by Newton's method with a line search. Where compression leaves the second derivative
// indefinite, inertia is added until it is definite. A factorisation is kept within a step for as long as it
// converges quickly.
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

  // Advances by one step. False if Newton's method did not converge, or to nothing finite; the motion must
  // not be used any more then. Throws Cancelled.
  bool step(Job& job);

  // Of all vertices, in metres and m/s.
  std::span<const Vec3> positions() const { return positions_; }
  std::span<const Vec3> velocities() const { return velocities_; }
  // Joules.
  double kineticEnergy() const;
  double elasticEnergy() const { return system_.energyAt(positions_); }
  double potentialEnergy() const;
  // Numbers of linear solves and of factorisations so far.
  uint32_t solveCount() const { return solveCount_; }
  uint32_t factorisationCount() const { return factorisationCount_; }

 private:
  using State = std::vector<Vec3>;
  // 1/2 inertia |x - aim|_M^2 + E(x), minimised by a step.
  struct Objective {
    double inertia;  // 1/s2
    State aim;
  };

  struct Point {
    State x;
    double value;  // of the objective
  };

  Objective objective() const;
  State predicted() const;
  double valueAt(const Objective& objective, const State& x) const;
  Eigen::VectorXd inertiaForce(const Objective& objective, const State& x) const;
  bool minimise(const Objective& objective, Point& point, Job& job);
  double moveAlong(const Objective& objective, const Eigen::VectorXd& direction, double growth,
                   Point& point) const;
  Eigen::VectorXd linearise(const Objective& objective, const State& x, Job& job);
  void advanceTo(State x);

  ImplicitOptions options_;
  ImplicitSystem system_;
  Factorisation factorisation_;
  std::vector<uint32_t> pinned_;
  bool isStarted_ = false;
  State positions_, velocities_, formerPositions_, formerVelocities_, pinTargets_;
  uint32_t solveCount_ = 0, factorisationCount_ = 0;
};

}  // namespace limber
