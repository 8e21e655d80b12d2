#include "fit/tune/modes/tuned_masses.h"

#include <algorithm>
#include <numeric>

#include "mesh/vertex_areas.h"

namespace limber {
namespace {

constexpr double kMinShare = 0.1;  // of a vertex's share by area

}  // namespace

std::vector<double> carryMasses(const std::deque<PartPair>& pairs, const TriangleMesh& result,
                                std::span<const double> masses) {
  const double total = std::accumulate(masses.begin(), masses.end(), 0.0);
  const std::vector<double> areas = lumpedAreas(result);
  const double density = total / std::accumulate(areas.begin(), areas.end(), 0.0);
  // Parts that are too small to matter have no pair and keep their share by area.
  std::vector<double> carried(result.vertexCount());
  std::ranges::transform(areas, carried.begin(), [&](double area) { return density * area; });
  for (const PartPair& pair : pairs) {
    for (const uint32_t v : pair.result.vertices) carried[v] = 0;
    for (size_t v = 0; v < pair.points.size(); ++v) {
      const SurfacePoint& point = pair.points[v];
      for (int c = 0; c < 3; ++c)
        carried[pair.result.vertices[pair.result.mesh.triangles[point.triangle][c]]] +=
            point.barycentric[c] * masses[pair.original.vertices[v]];
    }
  }
  for (uint32_t v = 0; v < result.vertexCount(); ++v)
    carried[v] = std::max(carried[v], kMinShare * density * areas[v]);
  const double scale = total / std::accumulate(carried.begin(), carried.end(), 0.0);
  for (double& mass : carried) mass *= scale;
  return carried;
}

}  // namespace limber
