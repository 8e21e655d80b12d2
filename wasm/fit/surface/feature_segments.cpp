#include "fit/surface/feature_segments.h"

#include <algorithm>

namespace limber {

FeatureSegments featureSegments(const TriangleMesh& mesh, const Topology& topology,
                                const EdgeList* featureEdges) {
  FeatureSegments found;
  found.segments.positions = mesh.positions;
  const auto isFeature = [&](const Topology::Edge& edge) {
    return edge.useCount == 1 ||
           (featureEdges && std::ranges::binary_search(*featureEdges, std::array{edge.a, edge.b}));
  };
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) {
      const Topology::Edge& edge = topology.edges[topology.edgeOpposite(Corner(t, c))];
      if (topology.trianglesAt(edge)[0] != t || !isFeature(edge)) continue;
      const int start = (c + 1) % 3, end = (c + 2) % 3;
      const auto& triangle = mesh.triangles[t];
      const uint32_t a = triangle[static_cast<size_t>(start)], b = triangle[static_cast<size_t>(end)];
      found.segments.triangles.push_back({a, b, b});
      found.triangle.push_back(t);
      found.corner.push_back({start, end});
    }
  return found;
}

}  // namespace limber
