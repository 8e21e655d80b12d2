#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"

namespace limber {

// A point of a surface, by barycentric coordinates in its triangle: barycentric[c] belongs to corner c, and
// the sum is 1. The triangle is kNone if there is no point.
struct SurfacePoint {
  uint32_t triangle = kNone;
  double barycentric[3] = {0, 0, 0};
};

// The position of a surface point if the vertices are at `positions`.
inline Vec3 positionOf(const SurfacePoint& point, std::span<const Triangle> triangles,
                       std::span<const Vec3> positions) {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) sum += positions[triangles[point.triangle][c]] * point.barycentric[c];
  return sum;
}

}  // namespace limber
