#include "mesh/surface_samples.h"

#include <algorithm>
#include <cmath>

#include "mesh/vertex_areas.h"

namespace limber {

namespace {

constexpr double kMaxOnEdge = 63;

struct EdgePoints {
  Vec3 from, step;
  int count;  // odd
};

// The two triangles of an edge traverse it in opposite directions: each contributes every second point, and
// the midpoint.
void add(const EdgePoints& edge, bool isUpwards, std::vector<Vec3>& out) {
  const int middle = (edge.count + 1) / 2;
  for (int k = 1; k <= edge.count; ++k)
    if (k == middle || (k % 2 == 1) == isUpwards) out.push_back(edge.from + edge.step * k);
}

}  // namespace

SurfaceSamples sampleSurface(const TriangleMesh& mesh, uint32_t count) {
  const double total = surfaceArea(mesh);
  SurfaceSamples samples;
  if (!(total > 0)) return samples;
  samples.positions.reserve(count);
  samples.triangles.reserve(count);
  // Powers of the plastic number give an additive two-dimensional sequence of low discrepancy (Roberts 2018).
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

std::vector<Vec3> sampleEdges(const TriangleMesh& mesh, double spacing) {
  std::vector<Vec3> points;
  for (const Triangle& triangle : mesh.triangles)
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t from = triangle[c], to = triangle[(c + 1) % 3];
      const Vec3& low = mesh.positions[std::min(from, to)];
      const Vec3& high = mesh.positions[std::max(from, to)];
      const double gaps = std::clamp(std::ceil(length(high - low) / spacing), 2.0, kMaxOnEdge + 1);
      const int count = (static_cast<int>(gaps) - 1) | 1;
      add({low, (high - low) * (1.0 / (count + 1)), count}, from < to, points);
    }
  return points;
}

}  // namespace limber
