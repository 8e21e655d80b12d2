#include "mesh/vertex_areas.h"

#include <algorithm>
#include <numeric>

namespace limber {

std::vector<double> lumpedAreas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertexCount(), 0.0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (uint32_t v : mesh.triangles[t]) areas[v] += triangleArea(mesh, t) / 3;
  const double mean =
      std::accumulate(areas.begin(), areas.end(), 0.0) / std::max<double>(1, mesh.vertexCount());
  for (double& area : areas) area = std::max(area, 1e-9 * mean);
  return areas;
}

}  // namespace limber
