#include "simulate/constraints/triangle_rest.h"

#include <algorithm>

namespace limber {

TriangleRest triangleRest(const TriangleMesh& mesh, uint32_t t) {
  const Vec3 a = mesh.corner(t, 1) - mesh.corner(t, 0), b = mesh.corner(t, 2) - mesh.corner(t, 0);
  const double longest = std::max({length(a), length(b), length(b - a)});
  if (longest == 0) return {1e-9, 0, 1e-9};  // a point gets an arbitrary small shape: it has almost no mass
  const double x1 = std::max(length(a), kFlattestRest * longest);
  const double least = kFlattestRest * longest * longest / x1;
  return {x1, dot(a, b) / x1, std::max(length(cross(a, b)) / x1, least)};
}

}  // namespace limber
