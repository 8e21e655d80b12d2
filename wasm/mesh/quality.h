#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// 4 sqrt(3) A / (l1^2 + l2^2 + l3^2), Eq. 9: 1 for an equilateral triangle, 0 without area.
double triangleQuality(const Vec3& a, const Vec3& b, const Vec3& c);

// The smallest angle of a triangle in degrees, 0 without area.
double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c);

struct QualityReport {
  double minAngle = 0;      // degrees, over all triangles
  double meanMinAngle = 0;  // degrees, mean over triangles of their smallest angle
  double minQuality = 0;    // Eq. 9
  double meanQuality = 0;
  std::vector<uint32_t> angleHistogram;  // triangles by smallest angle, 12 bins of 5 degrees over [0, 60]
};

QualityReport measureQuality(const TriangleMesh& mesh);

}  // namespace limber
