#pragma once

#include <vector>

namespace limber {

// Decides when a search has gained what it can: when the merit of the best state (a mean square, see
// SearchState::merit) is good enough, or when the last rounds have lowered it by little. Constants are in
// tuning::stopping.
class StopRule {
 public:
  // `favourSpeed`: the search ends earlier where frequencies are already right to 0.26 %.
  StopRule(double goodEnough, bool favourSpeed) : goodEnough_(goodEnough), favourSpeed_(favourSpeed) {}

  // To be called with the best merit after each round.
  void add(double bestMerit) { merits_.push_back(bestMerit); }
  // Measures progress from here on.
  void restart() { merits_.clear(); }

  bool isMet(double bestMerit) const;

 private:
  double goodEnough_;
  bool favourSpeed_;
  std::vector<double> merits_;
};

}  // namespace limber
