#pragma once

#include "mesh/triangle_mesh.h"

namespace limber {

// A triangle at rest in its own plane: corner 0 at the origin, corner 1 at (x1, 0), corner 2 at (x2, y2).
struct TriangleRest {
  double x1, x2, y2;
  double area() const { return 0.5 * x1 * y2; }
};

// The smallest ratio of height to longest edge of a triangle at rest. The height of flatter triangles is
// raised to it, so that a needle is stiff but not infinitely stiff.
inline constexpr double kFlattestRest = 1e-3;

TriangleRest triangleRest(const TriangleMesh& mesh, uint32_t t);

}  // namespace limber
