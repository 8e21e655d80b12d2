#pragma once

#include <cstdint>

#include "mesh/triangle_mesh.h"

namespace limber {

// A point of a surface by the barycentric coordinates of its triangle: barycentric[c] belongs to corner c,
// and the sum is 1. kNone as the triangle where there is no point.
struct SurfacePoint {
  uint32_t triangle = kNone;
  double barycentric[3] = {0, 0, 0};
};

}  // namespace limber
