#pragma once

#include <numbers>

#include "elastic/solvers/solver_model.h"
#include "linear/eigensolver.h"

namespace limber {

// The least and the greatest logarithm of a factor.
struct FactorRange {
  double least = -std::numbers::ln10, most = std::numbers::ln10;  // factors between 0.1 and 10
};

// The range of factors on bending: [0.1, 10] times 1 and times the factor that the resolution alone asks for,
// which keeps the bending stiffness of a smooth surface on triangles whose edges are `lengthRatio` times as
// long. It is lengthRatio^-4 for springs across edges: between corners of triangles of height h, across an
// edge with the rest angle h kappa, a spring of stiffness k resists that angle with k h^4 kappa^2 / 4.
FactorRange bendRange(BendElement element, double lengthRatio);

// The standard deviation of the prior of a factor's logarithm.
inline constexpr double kPriorDeviation = std::numbers::ln10 / 2;
// Squared residuals below this are errors of the eigensolver.
inline constexpr double kMinScatter = kRoughTolerance * kRoughTolerance;

}  // namespace limber
