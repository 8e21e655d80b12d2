#include "mesh/surface_samples.h"

#include <cmath>

namespace limber {

SurfaceSamples sampleSurface(const TriangleMesh& mesh, uint32_t count) {
  double total = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) total += triangleArea(mesh, t);
  SurfaceSamples samples;
  if (!(total > 0)) return samples;
  samples.positions.reserve(count);
  samples.triangles.reserve(count);
  // Powers of the plastic number give the additive two-dimensional sequence of least discrepancy (Roberts
  // 2018).
  constexpr double plastic = 1.32471795724474602596;
  uint32_t t = 0;
  double below = 0, area = triangleArea(mesh, 0);
  for (uint32_t i = 0; i < count; ++i) {
    const double target = total * (i + 0.5) / count;
    while (below + area < target && t + 1 < mesh.triangleCount()) {
      below += area;
      area = triangleArea(mesh, ++t);
    }
    double u = std::fmod((i + 1) / plastic, 1.0), v = std::fmod((i + 1) / (plastic * plastic), 1.0);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3& corner = mesh.corner(t, 0);
    samples.positions.push_back(corner + u * (mesh.corner(t, 1) - corner) + v * (mesh.corner(t, 2) - corner));
    samples.triangles.push_back(t);
  }
  return samples;
}

}  // namespace limber
