#include "fit/search/modal_search.h"

#include <utility>

#include "fit/search/budgeted_step.h"

namespace limber {

namespace {

Eigen::VectorXd displacement(const TriangleMesh& from, const TriangleMesh& to) {
  Eigen::VectorXd moved(3 * static_cast<Eigen::Index>(to.vertexCount()));
  for (uint32_t v = 0; v < to.vertexCount(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      moved[3 * static_cast<Eigen::Index>(v) + axis] = to.positions[v][axis] - from.positions[v][axis];
  return moved;
}

StepLimits withBounds(StepLimits limits, const DistanceBounds& bounds) {
  limits.distanceBounds = &bounds;
  return limits;
}

}  // namespace

ModalSearch::ModalSearch(const SearchProblem& problem, const SearchLimits& limits, Job& job)
    : problem_(problem),
      limits_(limits),
      evaluator_(problem, job),
      distanceBounds_(problem.treeOfOriginal, problem.part.result, evaluator_.topology()),
      guard_(problem.part.result, withBounds(limits.steps, distanceBounds_)),
      solver_(problem.part.locked, job),
      damping_(3 * static_cast<Eigen::Index>(problem.part.result.vertexCount()), limits.effort.initialDamping,
               limits.favourSpeed),
      stopRule_(limits.effort.goodEnough, limits.favourSpeed) {
  state_.mesh = problem.part.result;
  evaluator_.evaluate(state_);
  meanSquareBefore_ = state_.mismatch.meanSquare();
  best_ = state_;
}

TriangleMesh ModalSearch::run(const std::function<void(double)>& report) {
  const int mostRounds = limits_.effort.mostRounds;
  for (int round = 0; round < mostRounds && state_.mismatch.residual.size() > 0 && !isDone(); ++round) {
    report(static_cast<double>(round) / mostRounds);
    step();
    if (merit(state_) < merit(best_)) {
      best_ = state_;
      damping_.noteImprovement();
    } else if (merit(state_) > tuning::search::kLost * merit(best_)) {
      restoreBest();
    }
    stopRule_.add(merit(best_));
  }
  return best_.mesh;
}

bool ModalSearch::isDone() const {
  return damping_.isExhausted() || stopRule_.isMet(merit(best_));
}

void ModalSearch::step() {
  const Mismatch before = state_.mismatch;
  const Eigen::VectorXd wanted = gaussNewtonStep();
  TriangleMesh next = guard_.apply(state_.mesh, wanted);
  if (problem_.part.mirror) problem_.part.mirror->symmetrise(next);
  const Eigen::VectorXd made = displacement(state_.mesh, next);
  damping_.scaleBlocked(wanted, made);
  const Eigen::VectorXd predicted = before.residual + before.jacobian.transpose() * made;
  state_.mesh = std::move(next);
  evaluator_.evaluate(state_);
  const double squares = before.residual.squaredNorm();
  damping_.adapt(squares - state_.mismatch.residual.squaredNorm(), squares - predicted.squaredNorm());
}

// Solves for all columns at once; kStartWeight is a spring to the positions at the start.
Eigen::VectorXd ModalSearch::gaussNewtonStep() {
  constexpr double startWeight = tuning::search::kStartWeight;
  const FitPart& part = problem_.part;
  const Eigen::MatrixXd& jacobian = state_.mismatch.jacobian;
  const SurfaceFit& surface = state_.surface;
  const Eigen::VectorXd gradient =
      surface.gradient -
      startWeight * surface.dampingDiagonal.cwiseProduct(displacement(part.result, state_.mesh));
  Eigen::MatrixXd columns(gradient.size(), 1 + jacobian.cols());
  columns << gradient, jacobian;
  if (part.mirror) part.mirror->symmetrise(columns);
  const Eigen::VectorXd diagonal = damping_.scaled(surface.dampingDiagonal);
  Eigen::MatrixXd solved =
      solver_.solve({surface.hessian, diagonal, damping_.value() + startWeight}, std::move(columns));
  part.flatRegions.flatten(solved);
  return stepWithinBudget(gradient, std::move(solved));
}

// Spends the rest of the budget on the residuals.
Eigen::VectorXd ModalSearch::stepWithinBudget(const Eigen::VectorXd& gradient, Eigen::MatrixXd solved) const {
  const BudgetedStep budgeted(gradient, state_.mismatch, std::move(solved));
  const SurfaceFit& surface = state_.surface;
  const double left = (limits_.budget * limits_.budget - surface.meanSquare) * surface.area;
  const double unit = surface.area * limits_.budget * limits_.budget;
  return budgeted.step(budgeted.weightWithinBudget(left, tuning::search::kMinResidualWeight * unit,
                                                   limits_.effort.mostResidualWeight * unit));
}

// The next step starts from the best state with more damping.
void ModalSearch::restoreBest() {
  state_ = best_;
  problem_.target.startFrom(state_.modes);
  stopRule_.restart();
  damping_.noteRestore();
}

}  // namespace limber
