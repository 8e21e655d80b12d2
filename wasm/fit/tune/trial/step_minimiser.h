#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/job.h"
#include "fit/tune/trial/implicit_system.h"
#include "linear/factorisation.h"

namespace limber {

// What an implicit step minimises: 1/2 inertia |x - aim|_M^2 + E(x).
struct StepObjective {
  double inertia = 0;  // 1/s2
  std::vector<Vec3> aim = {};
};

// Finds the minimum of an implicit step by Newton's method with a line search.
//
// Newton's equations are solved by preconditioned conjugate gradients, which stop at a direction of negative
// curvature; the line search continues from the solution found so far (Steihaug 1983).
// The preconditioner is a factorisation at an earlier state of the body, of the part of its second derivative
// that is positive semidefinite whatever the stress, with its inertia. It is renewed when the iterations that
// it has cost since amount to a factorisation: so the work is at most about twice that of the best choice
// (the rule of ski rental); and once in a step whose iterations contract slowly. An elimination order serves
// all of them.
class StepMinimiser {
 public:
  using State = std::vector<Vec3>;

  // Refers to the system. `motionSize`: metres, what errors are relative to. `mostWork`: see work().
  StepMinimiser(ImplicitSystem& system, double motionSize, double mostWork);

  // Moves the free vertices of x to the minimum. False if Newton's method does not converge, or to nothing
  // finite, or once the work of all minima together is more than the most; x is of no meaning then. Throws
  // Cancelled.
  bool minimise(const StepObjective& objective, State& x, Job& job);
  double valueAt(const StepObjective& objective, const State& x) const;

  // Multiplications of all solves so far, and those of factorisations by the time that they take beside them.
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
  double rent_ = 0;           // solves since the last factorisation that a fresh one would have spared
  double factorInertia_ = 0;  // of the last factorisation, 0 before the first
  bool renews_ = true;        // whether the next linearisation factorises
  bool isFresh_ = false;      // whether the factorisation belongs to the last linearisation
  uint32_t solveCount_ = 0, factorisationCount_ = 0;
};

}  // namespace limber
