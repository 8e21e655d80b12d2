#pragma once

#include <compare>
#include <cstdint>

#include "mesh/triangle_mesh.h"

namespace limber {

// The two indices that follow c cyclically among the corners 0, 1, 2 of a triangle.
inline int nextIndex(int c) {
  return c == 2 ? 0 : c + 1;
}
inline int previousIndex(int c) {
  return c == 0 ? 2 : c - 1;
}

// One corner of a triangle: the triangle t < 2^30 and the index c, 0, 1 or 2, of the corner in it. Corners
// are ordered by triangle, then by index.
//
// Flat arrays with one value per corner, also those that cross to JavaScript, are indexed by `flatIndex`,
// 3 t + c. The object itself stores 4 t + c, so that t and c take one shift and one mask, not a division.
class Corner {
 public:
  Corner() = default;
  explicit Corner(uint32_t triangle, uint32_t index) : code_(4 * triangle + index) {}
  static Corner fromFlatIndex(uint32_t flatIndex) { return Corner(flatIndex / 3, flatIndex % 3); }
  static Corner fromCode(uint32_t code) {
    Corner corner;
    corner.code_ = code;
    return corner;
  }

  uint32_t triangle() const { return code_ >> 2; }
  int index() const { return static_cast<int>(code_ & 3); }
  uint32_t flatIndex() const { return 3 * triangle() + (code_ & 3); }
  // The stored number, for keys that contain a corner among other bits.
  uint32_t code() const { return code_; }

  auto operator<=>(const Corner&) const = default;

 private:
  uint32_t code_ = 0;
};

inline uint32_t vertexAt(const TriangleMesh& mesh, Corner corner) {
  return mesh.triangles[corner.triangle()][corner.index()];
}

// The corner of triangle t at vertex v, which must be one of its vertices.
inline Corner cornerAt(const TriangleMesh& mesh, uint32_t t, uint32_t v) {
  const Triangle& triangle = mesh.triangles[t];
  return Corner(t, triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2);
}

}  // namespace limber
