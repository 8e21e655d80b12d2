#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limber {

double triangleQuality(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double squares = squaredLength(b - a) + squaredLength(c - b) + squaredLength(a - c);
  return squares > 0 ? 2 * std::sqrt(3.0) * length(cross(b - a, c - a)) / squares : 0;
}

double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twiceArea = length(cross(b - a, c - a));
  if (!(twiceArea > 0)) return 0;
  const double smallest =
      std::min({std::atan2(twiceArea, dot(b - a, c - a)), std::atan2(twiceArea, dot(a - b, c - b)),
                std::atan2(twiceArea, dot(a - c, b - c))});
  return smallest * 180 / std::numbers::pi;
}

QualityReport measureQuality(const TriangleMesh& mesh) {
  constexpr int bins = 12;
  QualityReport report;
  report.angleHistogram.assign(bins, 0);
  if (mesh.triangles.empty()) return report;
  report.minAngle = 60;
  report.minQuality = 1;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vec3 &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const double angle = smallestAngle(a, b, c), quality = triangleQuality(a, b, c);
    report.minAngle = std::min(report.minAngle, angle);
    report.meanMinAngle += angle;
    report.minQuality = std::min(report.minQuality, quality);
    report.meanQuality += quality;
    ++report.angleHistogram[std::min(bins - 1, static_cast<int>(angle / 5))];
  }
  report.meanMinAngle /= mesh.triangleCount();
  report.meanQuality /= mesh.triangleCount();
  return report;
}

}  // namespace limber
