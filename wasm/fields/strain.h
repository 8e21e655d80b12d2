#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// |E|_F per triangle, E = (F^T F - I) / 2 in the triangle's rest tangent frame (paper 3.1, Eq. 5 at
// sin(theta) = 1), of the displacement shape[3 * v + c] times `amplitude`. 0 for a triangle without area.
std::vector<double> greenLagrangeStrain(const TriangleMesh& mesh, std::span<const float> shape,
                                        double amplitude);

// One mode's share in Eq. 6: its strain per triangle and its weight w_k there (weights differ between
// components).
struct WeightedStrain {
  std::vector<double> strain;             // per triangle
  std::vector<double> weightOfComponent;  // per component, >= 0
};

// sigma(T) = (sum_k w_k |E_k(T)|^p)^(1/p), Eq. 6; p in [1, infinity], infinity takes the largest w_k |E_k|.
std::vector<double> combineStrain(std::span<const WeightedStrain> ordinals,
                                  std::span<const uint32_t> componentOfTriangle, double p);

// (number below + half of the ties) / n within each group, in [0, 1]: an element alone, or all equal, gets
// 1/2. A tie counts the others only plus itself half, so the ranks of n distinct values are (i + 1/2) / n.
std::vector<float> rankWithin(std::span<const double> values, std::span<const uint32_t> group,
                              uint32_t groupCount);

}  // namespace limber
