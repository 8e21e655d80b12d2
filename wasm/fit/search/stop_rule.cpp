#include "fit/search/stop_rule.h"

#include <cmath>

#include "fit/tuning.h"

namespace limber {

bool StopRule::isMet(double bestMerit) const {
  namespace constants = tuning::stopping;
  if (bestMerit < goodEnough_) return true;
  if (merits_.size() <= constants::kPatience) return false;
  const double before = merits_[merits_.size() - 1 - constants::kPatience], now = merits_.back();
  const bool isFine = favourSpeed_ && now < constants::kFine;
  const double gained = std::sqrt(before) - std::sqrt(now);
  return (isFine && gained < constants::kLittleRootOfFine) ||
         (now > constants::kStagnant * before && gained < constants::kLittleRoot);
}

}  // namespace limber
