#include "fit/reach.h"

#include <algorithm>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr double kReach = 0.05;  // of the mean length of the edges around a vertex
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

Reach::Reach(const TriangleMesh& surface, const TriangleMesh& start, const Topology& topology)
    : tree_(surface), vertices_(start.vertexCount()) {
  const std::vector<double> edges = meanEdges(start, topology);
  parallelFor(vertices_.size(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (size_t v = begin; v < end; ++v) {
      const double distance = tree_.closest(start.positions[v]).distance;
      vertices_[v] = {start.positions[v], distance, std::max(distance, kReach * edges[v])};
    }
  });
}

Vec3 Reach::limited(uint32_t v, const Vec3& place) const {
  const auto& [start, distance, most] = vertices_[v];
  if (distance + length(place - start) <= most) return place;
  const ClosestPoint nearest = tree_.closest(place);
  if (nearest.distance <= most) return place;
  return nearest.position + (place - nearest.position) * (most / nearest.distance);
}

}  // namespace limber
