#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "base/vec3.h"

namespace limber {

// Unites points that are closer than `distance` (> 0, in the points' units), directly or through a chain of
// such pairs. Returns per point the lowest point that it is one with. Time grows with the number of pairs, so
// a distance of many edge lengths is slow; job.check is called on the way. Throws Cancelled.
std::vector<uint32_t> uniteCloseVertices(const std::vector<Vec3>& points, double distance, Job& job);

}  // namespace limber
