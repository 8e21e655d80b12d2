#pragma once

#include <vector>

namespace limber {

// The convergence test of a search: it ends when the merit of the best state (a mean square, see
// SearchState::merit) is good enough, or when the last rounds have lowered it by little. Constants are in
// tuning::stopping.
class StopRule {
 public:
  // `favourSpeed`: the search ends earlier once frequencies are accurate to 0.26 %.
  StopRule(double goodEnough, bool favourSpeed) : goodEnough_(goodEnough), favourSpeed_(favourSpeed) {}

  // Must be called with the best merit after each round.
  void add(double bestMerit) { merits_.push_back(bestMerit); }
  // Restarts the judgement of progress.
  void restart() { merits_.clear(); }

  bool isMet(double bestMerit) const;

 private:
  double goodEnough_;
  bool favourSpeed_;
  std::vector<double> merits_;
};

}  // namespace limber
