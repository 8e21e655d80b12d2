#pragma once

#include <cmath>
#include <numbers>

#include "base/real_pair.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// 4 sqrt(3) A / (l1^2 + l2^2 + l3^2) for a triangle of area A and edge lengths l1, l2, l3 (Eq. 9): 1 for an
// equilateral triangle, 0 for one without area.
inline double triangleQuality(const Vec3& p, const Vec3& q, const Vec3& r) {
  const double squares = squaredLength(q - p) + squaredLength(r - q) + squaredLength(p - r);
  return squares > 0 ? 2 * std::numbers::sqrt3 * length(cross(q - p, r - p)) / squares : 0;
}

// The squares of the qualities of two triangles, computed together and without a root.
inline RealPair squaredTriangleQuality(const Point<RealPair>& p, const Point<RealPair>& q,
                                       const Point<RealPair>& r) {
  const Point<RealPair> u = q - p, v = r - p, w = r - q, n = cross(u, v);
  const RealPair squares = dot(u, u) + dot(v, v) + dot(w, w);
  const RealPair quality = 12 * dot(n, n) / (squares * squares);
  return squares > 0 ? quality : RealPair{};
}

// The smallest angle of a triangle in degrees, in [0, 60]; 0 for a triangle without area.
double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c);

// Degrees; 0 for a mesh without triangles.
struct QualityReport {
  double minAngle = 0;      // over all triangles
  double meanMinAngle = 0;  // mean over the triangles of their smallest angles
};

QualityReport measureQuality(const TriangleMesh& mesh);

// The mean over the triangles' sides, in units of the mesh: an edge between two triangles counts twice.
double meanSide(const TriangleMesh& mesh);

}  // namespace limber
