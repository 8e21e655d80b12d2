#pragma once

#include <deque>
#include <span>
#include <vector>

#include "fit/tune/modes/tune_parts.h"

namespace limber {

// Masses of the original carried over to the vertices of the result, in kg: the mass of each vertex of the
// original is distributed to the corners of its closest point by barycentric weights. No vertex gets less
// than a tenth of its share by area, because solvers treat a vertex without mass as fixed. The sum equals
// that of `masses` up to rounding. `masses`: per vertex of the original body.
std::vector<double> carryMasses(const std::deque<PartPair>& pairs, const TriangleMesh& result,
                                std::span<const double> masses);

}  // namespace limber
