#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"

namespace limber {

// A point of a surface by the barycentric coordinates of its triangle: barycentric[c] belongs to corner c,
// and the sum is 1. kNone as the triangle where there is no point.
struct SurfacePoint {
  uint32_t triangle = kNone;
  double barycentric[3] = {0, 0, 0};
};

// Where a point of a surface is when the vertices are at `positions`.
inline Vec3 positionOf(const SurfacePoint& point, std::span<const Triangle> triangles,
                       std::span<const Vec3> positions) {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) sum += positions[triangles[point.triangle][c]] * point.barycentric[c];
  return sum;
}

}  // namespace limber
