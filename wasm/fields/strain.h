#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The Frobenius norm |E|_F of the Green-Lagrange strain per triangle, E = (F^T F - I) / 2 in the tangent
// frame of the rest triangle (paper, section 3.1, Eq. 5 with sin(theta) = 1), for the displacement shape[3 v
// + c] times `amplitude`. 0 for a triangle without area, or with so little that its strain overflows. O(n).
std::vector<double> greenLagrangeStrain(const TriangleMesh& mesh, std::span<const float> shape,
                                        double amplitude);

// One mode of Eq. 6: its strain per triangle, and its weight w_k, which differs between components.
struct WeightedStrain {
  std::vector<double> strain;             // per triangle
  std::vector<double> weightOfComponent;  // per component, >= 0
};

// sigma(T) = (sum_k w_k |E_k(T)|^p)^(1/p) per triangle (paper, Eq. 6), p in [1, infinity]. For p = infinity,
// the largest w_k |E_k(T)|. Weights may be infinite, such as those of frequencies near 0.
std::vector<double> combineStrain(std::span<const WeightedStrain> ordinals,
                                  std::span<const uint32_t> componentOfTriangle, double p);

// The rank of each value within its group, in (0, 1): (number of smaller values + half of the equal ones,
// itself included) over the size of the group. So n distinct values have the ranks (i + 1/2) / n, and equal
// values all have 1/2. No value may be NaN. O(n log n).
std::vector<float> rankWithin(std::span<const double> values, std::span<const uint32_t> group,
                              uint32_t groupCount);

}  // namespace limber
