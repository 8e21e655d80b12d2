#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace limber {

inline constexpr uint32_t kNone = 0xffffffffu;  // no index

using Triangle = std::array<uint32_t, 3>;

// An indexed triangle surface. The corners of a triangle run counter-clockwise seen from outside. Positions
// are in the units of the file; every coordinate of a mesh made by `weld` is an exact float32.
struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;

  uint32_t vertexCount() const { return static_cast<uint32_t>(positions.size()); }
  uint32_t triangleCount() const { return static_cast<uint32_t>(triangles.size()); }
  // The position of corner c of triangle t.
  const Vec3& corner(uint32_t t, int c) const { return positions[triangles[t][c]]; }
};

// Twice the area times the unit normal of a triangle.
inline Vec3 areaNormal(const TriangleMesh& mesh, uint32_t t) {
  return cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
}
inline double triangleArea(const TriangleMesh& mesh, uint32_t t) {
  return 0.5 * length(areaNormal(mesh, t));
}

inline Vec3 triangleCentre(const TriangleMesh& mesh, uint32_t t) {
  return (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
}

// Per vertex the unit normal: the area-weighted mean over its triangles, normalised; 0 if they cancel out.
std::vector<Vec3> vertexNormals(const TriangleMesh& mesh);

// An axis-aligned box.
struct Bounds {
  Vec3 low, high;

  double diagonal() const { return length(high - low); }
  // The axis of the longest side, the first of equal ones.
  int longestAxis() const {
    const Vec3 size = high - low;
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (size[axis] > size[longest]) longest = axis;
    return longest;
  }
  // Widens the box so that it contains a point or another box.
  void include(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  void include(const Bounds& box) {
    include(box.low);
    include(box.high);
  }
};
// The bounding box of the vertices; both of its corners are 0 for a mesh without vertices.
Bounds bounds(const TriangleMesh& mesh);
// The bounding box of triangle t.
inline Bounds bounds(const TriangleMesh& mesh, uint32_t t) {
  Bounds box{mesh.corner(t, 0), mesh.corner(t, 0)};
  for (int c = 1; c < 3; ++c) box.include(mesh.corner(t, c));
  return box;
}

}  // namespace limber
