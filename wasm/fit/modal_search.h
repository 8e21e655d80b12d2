#pragma once

#include <functional>
#include <vector>

#include "base/job.h"
#include "fit/fit_part.h"
#include "fit/fit_solver.h"
#include "fit/guarded_step.h"
#include "fit/modal_target.h"

namespace limber {

struct SearchLimits {
  double budget = 0;  // root mean square distance, in units of the part
  int mostRounds = 24;
  double goodEnough = 1e-6;  // mean square of the mismatch
  // Where rounds take time: towards longer steps sooner, and to an end where little is gained.
  bool isBrisk = false;
  // How firmly vertices hold their places: more where a step gains less than foretold.
  double firstHold = 0.01;
  double mostWorth = 700;  // of a residual, in squared budgets of distance
  StepLimits steps = {};
};

// Gauss-Newton rounds towards the original's modes within a budget of distance from its surface. To be used
// within a WholePhase.
class ModalSearch {
 public:
  // Keeps references.
  ModalSearch(const FitPart& part, const FitSamples& samples, ModalTarget& target, const SearchLimits& limits,
              Job& job);

  // The best mesh of all rounds: the least mismatch, where distances beyond the budget count against it.
  // `report` takes the fraction that is done. Throws Cancelled.
  TriangleMesh run(const std::function<void(double)>& report);

  double meanSquareBefore() const { return before_; }
  double meanSquareAfter() const { return best_.mismatch.meanSquare(); }

 private:
  struct State {
    TriangleMesh mesh;
    Mismatch mismatch;
    SurfaceFit fit;
    ModalTarget::Found found;
  };
  class TradeOff;

  void measure();
  void step();
  Eigen::VectorXd gaussNewtonStep();
  double affordable(const TradeOff& tradeOff) const;
  void holdBlocked(const Eigen::VectorXd& wanted, const Eigen::VectorXd& made);
  void goBack();
  bool isDone() const;
  double merit(const State& state) const;

  const FitPart& part_;
  const FitSamples& samples_;
  ModalTarget& target_;
  SearchLimits limits_;
  Job& job_;
  Topology topology_;
  Reach reach_;
  GuardedStep guard_;
  FitSolver solver_;
  State state_, best_;
  std::vector<double> merits_;  // of the best mesh after each round since the last retreat
  int retreats_ = 0;            // one after the other
  Eigen::ArrayXd firmness_;     // per coordinate: by what its inertia is multiplied
  double hold_, before_ = 0;
};

}  // namespace limber
