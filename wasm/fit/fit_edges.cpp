#include "fit/fit_edges.h"

#include <algorithm>

#include "transfer/chart_sides.h"

namespace limber {

namespace {

// A corner of the result belongs to the same side (see ChartSides) as the corner of the original that it
// comes from. An edge is a seam if the corners of its two triangles at one end are on different sides.
EdgeList seamsOfResult(const MeshAt& result, const ChartSides& sides) {
  const TriangleMesh& mesh = result.mesh;
  const Topology topology = buildIncidence(mesh);
  const auto sideAt = [&](uint32_t t, uint32_t v) {
    return sides.sideOf(Corner(result.inputOfTriangle[t], cornerAt(mesh, t, v).index()));
  };
  EdgeList seams;
  for (const Topology::Edge& edge : topology.edges) {
    const auto around = topology.trianglesAt(edge);
    if (around.size() == 2 && (sideAt(around[0], edge.a) != sideAt(around[1], edge.a) ||
                               sideAt(around[0], edge.b) != sideAt(around[1], edge.b)))
      seams.push_back({edge.a, edge.b});
  }
  return seams;
}

EdgeList seamsOfOriginal(const Topology& topology, const ChartSides& sides) {
  EdgeList seams;
  for (uint32_t e = 0; e < topology.edges.size(); ++e)
    if (sides.isSeam(e) && topology.edges[e].useCount == 2)
      seams.push_back({topology.edges[e].a, topology.edges[e].b});
  return seams;
}

// The edges and their mirror images, sorted and without duplicates.
EdgeList withImages(EdgeList edges, const std::vector<uint32_t>& partners) {
  const size_t count = edges.size();
  for (size_t i = 0; i < count; ++i) {
    const auto [a, b] = std::minmax(partners[edges[i][0]], partners[edges[i][1]]);
    edges.push_back({a, b});
  }
  std::ranges::sort(edges);
  const auto repeated = std::ranges::unique(edges);
  edges.erase(repeated.begin(), repeated.end());
  return edges;
}

}  // namespace

FitEdges findFitEdges(const FitEdgesInput& input, const FitConstraints& constraints) {
  const auto& [original, topology, result, mirror] = input;
  const ChartSides sides(original, topology, constraints.charts, result);
  const EdgeList seams = seamsOfResult(result, sides);
  FitEdges found;
  if (constraints.keepsSeams) {
    found.original = seamsOfOriginal(topology, sides);
    found.result = seams;
  } else {
    const ChartSides groups(original, topology, {{}, constraints.charts.groups}, result);
    found.original = seamsOfOriginal(topology, groups);
    found.result = seamsOfResult(result, groups);
  }
  found.fixed = mirror ? withImages(seams, mirror->partners) : seams;
  return found;
}

}  // namespace limber
