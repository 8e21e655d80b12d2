#pragma once

#include <cstdint>

#include "mesh/triangle_mesh.h"

namespace limber {

// A point of a surface: barycentric[0] of corner 0, [1] of corner 1 and [2] of corner 2 of a triangle.
struct SurfacePoint {
  uint32_t triangle = kNone;
  double barycentric[3] = {0, 0, 0};
};

}  // namespace limber
