#pragma once

#include <numbers>

#include "linear/eigensolver.h"

namespace limber {

// In logarithms: factors lie between 0.1 and 10.
inline constexpr double kFactorRange = std::numbers::ln10;
// The range is two standard deviations of what a factor may be before anything has been measured.
inline constexpr double kPriorDeviation = kFactorRange / 2;
// Squared residuals below this are the eigensolver's.
inline constexpr double kLeastScatter = kRoughTolerance * kRoughTolerance;

}  // namespace limber
