#pragma once

#include <numbers>

#include "linear/eigensolver.h"

namespace limber {

// The range of the logarithm of a factor: factors lie between 0.1 and 10.
inline constexpr double kFactorRange = std::numbers::ln10;
// The range is two standard deviations of the prior of a factor.
inline constexpr double kPriorDeviation = kFactorRange / 2;
// Squared residuals below this are errors of the eigensolver.
inline constexpr double kMinScatter = kRoughTolerance * kRoughTolerance;

}  // namespace limber
