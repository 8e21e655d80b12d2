#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/job.h"
#include "fit/tune/trial/implicit_system.h"
#include "linear/factorisation.h"

namespace limber {

// The objective of an implicit step: 1/2 inertia |x - aim|_M^2 + E(x).
struct StepObjective {
  double inertia = 0;  // 1/s2
  std::vector<Vec3> aim = {};
};

// Finds the minimum of an implicit step by Newton's method with a line search.
//
// The Newton equations are solved by preconditioned conjugate gradients, which stop at a direction of
// negative curvature and return the iterate so far to the line search (Steihaug 1983). The preconditioner is
// a factorisation at an earlier state of the body: of the part of its second derivative that is positive
// semidefinite for any stress, plus inertia. It is renewed when the additional iterations since then cost as
// much as a factorisation, which bounds the work by about twice that of the best choice (the ski rental
// rule), and once in a step whose iterations converge slowly. All factorisations share an elimination order.
class StepMinimiser {
 public:
  using State = std::vector<Vec3>;

  // Keeps a reference to the system. `motionSize`: metres, to which errors are relative. `mostWork`: see
  // work().
  StepMinimiser(ImplicitSystem& system, double motionSize, double mostWork);

  // Moves the free vertices of x to the minimum. Returns false if Newton's method does not converge to finite
  // values, or once the total work exceeds the limit; x is then undefined. Throws Cancelled.
  bool minimise(const StepObjective& objective, State& x, Job& job);
  double valueAt(const StepObjective& objective, const State& x) const;

  // The work so far: multiplications of all solves, plus factorisations, converted to multiplications of
  // equal time.
  double work() const { return (solveCount_ + price_ * factorisationCount_) * solveWork_; }

 private:
  struct Point {
    State x;
    double value;  // of the objective
  };

  Eigen::VectorXd linearise(const StepObjective& objective, const State& x, Job& job);
  void factorise(double inertia, const State& x, Job& job);
  Eigen::VectorXd newtonDirection(const Eigen::VectorXd& gradient, double inertia, Job& job);
  double moveAlong(const StepObjective& objective, const Eigen::VectorXd& direction, double growth,
                   Point& point) const;
  Eigen::VectorXd product(const Eigen::VectorXd& x, double inertia) const;

  ImplicitSystem& system_;
  Factorisation factorisation_;
  double motionSize_, mostWork_;
  double solveWork_;          // multiplications of a solve
  double price_;              // of a factorisation, in solves
  double rent_ = 0;           // solves since the last factorisation that a fresh one would have saved
  double factorInertia_ = 0;  // of the last factorisation, 0 before the first
  bool renews_ = true;        // whether the next linearisation factorises
  bool isFresh_ = false;      // whether the factorisation belongs to the last linearisation
  uint32_t solveCount_ = 0, factorisationCount_ = 0;
};

}  // namespace limber
