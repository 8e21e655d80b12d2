#include "fit/search/distance_bounds.h"

#include <algorithm>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr double kEdgeFraction = 0.05;  // of the mean length of the edges around a vertex
constexpr size_t kVerticesPerRange = 256;

std::vector<double> meanEdges(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<double> mean(mesh.vertexCount(), 0), count(mesh.vertexCount(), 0);
  for (const Topology::Edge& edge : topology.edges)
    for (const uint32_t v : {edge.a, edge.b}) {
      mean[v] += length(mesh.positions[edge.b] - mesh.positions[edge.a]);
      count[v] += 1;
    }
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) mean[v] /= std::max(1.0, count[v]);
  return mean;
}

}  // namespace

DistanceBounds::DistanceBounds(const ClosestPointTree& surface, const TriangleMesh& start,
                               const Topology& topology)
    : surface_(surface), bounds_(start.vertexCount()) {
  const std::vector<double> edges = meanEdges(start, topology);
  parallelFor(bounds_.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    uint32_t near = kNone;
    for (size_t v = begin; v < end; ++v) {
      const double allowed = kEdgeFraction * edges[v];
      const ClosestPoint close = surface_.nearEnough(start.positions[v], allowed, near);
      near = close.triangle;
      bounds_[v] = {start.positions[v], close.distance, std::max(close.distance, allowed), near};
    }
  });
}

Vec3 DistanceBounds::limited(uint32_t v, const Vec3& target) const {
  const auto& [start, startDistance, most, near] = bounds_[v];
  // By the triangle inequality; saves the search for most vertices.
  if (startDistance + length(target - start) <= most) return target;
  const ClosestPoint nearest = surface_.nearEnough(target, most, near);
  if (nearest.distance <= most) return target;
  return nearest.position + (target - nearest.position) * (most / nearest.distance);
}

}  // namespace limber
