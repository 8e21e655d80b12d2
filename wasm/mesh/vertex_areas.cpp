#include "mesh/vertex_areas.h"

#include <algorithm>
#include <numeric>

namespace limber {
namespace {

constexpr double kMinArea = 1e-9;  // of the mean

}  // namespace

double surfaceArea(const TriangleMesh& mesh) {
  double area = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) area += triangleArea(mesh, t);
  return area;
}

std::vector<double> vertexAreas(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertexCount(), 0.0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const double third = triangleArea(mesh, t) / 3;
    for (const uint32_t v : mesh.triangles[t]) areas[v] += third;
  }
  return areas;
}

std::vector<double> lumpedAreas(const TriangleMesh& mesh) {
  std::vector<double> areas = vertexAreas(mesh);
  const double mean =
      std::accumulate(areas.begin(), areas.end(), 0.0) / std::max<double>(1, mesh.vertexCount());
  for (double& area : areas) area = std::max(area, kMinArea * mean);
  return areas;
}

}  // namespace limber
