#pragma once

#include <functional>

#include "base/job.h"
#include "fit/search/damping.h"
#include "fit/search/distance_bounds.h"
#include "fit/search/fit_solver.h"
#include "fit/search/guarded_step.h"
#include "fit/search/search_state.h"
#include "fit/search/stop_rule.h"
#include "fit/tuning.h"

namespace limber {

struct SearchLimits {
  double budget = 0;         // largest root mean square distance from the original, in units of the part
  bool favourSpeed = false;  // if rounds take long: longer steps sooner, and an end when little is gained
  StepLimits steps = {};
  tuning::SearchEffort effort = tuning::kSearch;
};

// Gauss-Newton rounds that move the vertices of a result until it has the modes of its original, within a
// budget of distance from the original's surface. Each round minimises
//   E(dx) + mu |dx|_D^2 + w |r + J dx|^2
// over the displacements dx, where E is the surface distance (SurfaceFit), r the mismatch of modes (Mismatch)
// and J its Jacobian, mu and D the damping (Damping), and w as large as the budget allows (BudgetedStep). A
// guarded step (GuardedStep) shortens dx so that no face flips or degrades. To be used within a WholePhase.
class ModalSearch {
 public:
  // Keeps references to the objects of the problem and the limits. Throws Cancelled.
  ModalSearch(const SearchProblem& problem, const SearchLimits& limits, Job& job);

  // The mesh of least merit among all rounds (SearchState::merit). `report` is called with the completed
  // fraction. Throws Cancelled.
  TriangleMesh run(const std::function<void(double)>& report);

  // Of the mismatch, at the start and of the best mesh.
  double meanSquareBefore() const { return meanSquareBefore_; }
  double meanSquareAfter() const { return best_.mismatch.meanSquare(); }

 private:
  bool isDone() const;
  void step();
  Eigen::VectorXd gaussNewtonStep();
  Eigen::VectorXd stepWithinBudget(const Eigen::VectorXd& gradient, Eigen::MatrixXd solved) const;
  void restoreBest();
  double merit(const SearchState& state) const { return state.merit(limits_.budget); }

  SearchProblem problem_;
  SearchLimits limits_;
  StateEvaluator evaluator_;
  DistanceBounds distanceBounds_;
  GuardedStep guard_;
  FitSolver solver_;
  Damping damping_;
  StopRule stopRule_;
  SearchState state_, best_;
  double meanSquareBefore_ = 0;
};

}  // namespace limber
