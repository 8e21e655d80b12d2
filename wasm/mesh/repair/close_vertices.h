#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "base/vec3.h"

namespace limber {

// Merges points that are closer than `distance` (> 0, in the units of the points), directly or through a
// chain of such pairs. Returns per point the lowest index of its set. Time grows with the number of pairs, so
// a distance of many edge lengths is slow. Throws Cancelled.
std::vector<uint32_t> uniteCloseVertices(const std::vector<Vec3>& points, double distance, Job& job);

}  // namespace limber
