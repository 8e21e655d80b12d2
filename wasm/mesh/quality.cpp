#include "mesh/quality.h"

#include <algorithm>
#include <vector>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr size_t kTrianglesPerRange = 8192;

}  // namespace

double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twiceArea = length(cross(b - a, c - a));
  if (!(twiceArea > 0)) return 0;
  const double smallest =
      std::min({std::atan2(twiceArea, dot(b - a, c - a)), std::atan2(twiceArea, dot(a - b, c - b)),
                std::atan2(twiceArea, dot(a - c, b - c))});
  return smallest * 180 / std::numbers::pi;
}

QualityReport measureQuality(const TriangleMesh& mesh) {
  QualityReport report;
  if (mesh.triangles.empty()) return report;
  report.minAngle = 60;
  std::vector<double> angles(mesh.triangleCount());
  parallelFor(angles.size(), kTrianglesPerRange, [&](size_t begin, size_t end) {
    for (auto t = static_cast<uint32_t>(begin); t < end; ++t)
      angles[t] = smallestAngle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
  });
  for (const double angle : angles) {
    report.minAngle = std::min(report.minAngle, angle);
    report.meanMinAngle += angle;
  }
  report.meanMinAngle /= mesh.triangleCount();
  return report;
}

double meanSide(const TriangleMesh& mesh) {
  double sum = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) sum += length(mesh.corner(t, (c + 1) % 3) - mesh.corner(t, c));
  return sum / (3.0 * mesh.triangleCount());
}

}  // namespace limber
