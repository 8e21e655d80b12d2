#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace limber {

inline constexpr uint32_t kNone = 0xffffffffu;

using Triangle = std::array<uint32_t, 3>;

// An indexed triangle surface. Corners run counter-clockwise seen from outside.
// Positions are in the units of the file; every coordinate of a mesh that came out of `weld` is an exact
// float32.
struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;

  uint32_t vertexCount() const { return static_cast<uint32_t>(positions.size()); }
  uint32_t triangleCount() const { return static_cast<uint32_t>(triangles.size()); }
  const Vec3& corner(uint32_t t, int c) const { return positions[triangles[t][c]]; }
};

// Twice the area times the unit normal of a triangle.
inline Vec3 areaNormal(const TriangleMesh& mesh, uint32_t t) {
  return cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
}
inline double triangleArea(const TriangleMesh& mesh, uint32_t t) {
  return 0.5 * length(areaNormal(mesh, t));
}

// Unit normals per vertex, weighted by area; 0 where they cancel out.
std::vector<Vec3> vertexNormals(const TriangleMesh& mesh);

// The axis-aligned bounding box of the vertices; both corners are 0 for a mesh without vertices.
struct Bounds {
  Vec3 low, high;
  double diagonal() const { return length(high - low); }
};
Bounds bounds(const TriangleMesh& mesh);

}  // namespace limber
