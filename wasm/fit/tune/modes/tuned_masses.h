#pragma once

#include <deque>
#include <span>
#include <vector>

#include "fit/tune/modes/tune_parts.h"

namespace limber {

// Masses of the original carried over to the vertices of the result, in kg: each vertex of the original gives
// its own to the corners of its closest point by barycentric weights. No vertex gets less than a tenth of its
// share of the area, because solvers take a vertex without mass for a fixed one. The sum is that of
// `masses`, to rounding. `masses`: per vertex of the original body.
std::vector<double> carryMasses(const std::deque<PartPair>& pairs, const TriangleMesh& result,
                                std::span<const double> masses);

}  // namespace limber
