#include "fit/search/damping.h"

#include <algorithm>
#include <cmath>

#include "fit/tuning.h"

namespace limber {

namespace constants = tuning::damping;

Damping::Damping(Eigen::Index coordinateCount, double initial, bool favourSpeed)
    : value_(initial), favourSpeed_(favourSpeed), scale_(Eigen::ArrayXd::Ones(coordinateCount)) {}

bool Damping::isExhausted() const {
  return value_ >= constants::kMax;
}

Eigen::VectorXd Damping::scaled(const Eigen::VectorXd& dampingDiagonal) const {
  return dampingDiagonal.array() * scale_;
}

void Damping::adapt(double gain, double predicted) {
  if (gain < constants::kPoorGain * predicted) {
    value_ = std::min(constants::kMax, constants::kIncrease * value_);
  } else if (gain > constants::kGoodGain * predicted) {
    const bool isFast = favourSpeed_ && gain > constants::kFullGain * predicted;
    value_ = std::max(constants::kMin, value_ / (isFast ? constants::kFastDecrease : constants::kDecrease));
  }
}

void Damping::scaleBlocked(const Eigen::VectorXd& wanted, const Eigen::VectorXd& made) {
  for (Eigen::Index at = 0; at < wanted.size(); at += 3) {
    const bool isBlocked = made.segment<3>(at).norm() < constants::kBlocked * wanted.segment<3>(at).norm();
    scale_.segment<3>(at).setConstant(
        isBlocked ? std::min(constants::kMaxScale, constants::kBlockedIncrease * scale_[at])
                  : std::max(1.0, scale_[at] / constants::kFreedDecrease));
  }
}

void Damping::noteRestore() {
  const int count = favourSpeed_ ? ++restores_ : 1;
  value_ = std::min(constants::kMax, std::pow(constants::kIncrease, 1 + count) * value_);
}

}  // namespace limber
