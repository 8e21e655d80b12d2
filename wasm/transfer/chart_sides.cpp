#include "transfer/chart_sides.h"

#include <algorithm>
#include <numeric>

#include "base/disjoint_sets.h"

namespace limber {

ChartSides::ChartSides(const TriangleMesh& original, const Topology& topology, const Charts& charts,
                       const MeshAt& result)
    : isSeam_(topology.edges.size(), 0), seamCount_(original.vertexCount(), 0) {
  findSeams(original, topology, charts);
  joinCorners(original, topology, result.vertexOfInput);
  sortCorners(original, result);
}

void ChartSides::findSeams(const TriangleMesh& original, const Topology& topology, const Charts& charts) {
  const auto differs = [&](uint32_t first, uint32_t second, uint32_t v) {
    return charts.wedges[cornerAt(original, first, v).flatIndex()] !=
           charts.wedges[cornerAt(original, second, v).flatIndex()];
  };
  for (uint32_t e = 0; e < topology.edges.size(); ++e) {
    const Topology::Edge& edge = topology.edges[e];
    const auto triangles = topology.trianglesAt(edge);
    isSeam_[e] = triangles.size() != 2 ||
                 (!charts.groups.empty() && charts.groups[triangles[0]] != charts.groups[triangles[1]]) ||
                 (!charts.wedges.empty() && (differs(triangles[0], triangles[1], edge.a) ||
                                             differs(triangles[0], triangles[1], edge.b)));
    if (!isSeam_[e]) continue;
    ++seamCount_[edge.a];
    ++seamCount_[edge.b];
  }
}

void ChartSides::joinCorners(const TriangleMesh& original, const Topology& topology,
                             const std::vector<uint32_t>& vertexOfInput) {
  DisjointSets sides(3 * size_t{original.triangleCount()});
  for (uint32_t t = 0; t < original.triangleCount(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int next = (c + 1) % 3;
      const auto& triangle = original.triangles[t];
      if (vertexOfInput[triangle[c]] == vertexOfInput[triangle[next]])
        sides.unite(Corner(t, c).flatIndex(), Corner(t, next).flatIndex());
    }
  for (uint32_t e = 0; e < topology.edges.size(); ++e) {
    if (isSeam_[e]) continue;
    const Topology::Edge& edge = topology.edges[e];
    const auto triangles = topology.trianglesAt(edge);
    for (const uint32_t v : {edge.a, edge.b})
      sides.unite(cornerAt(original, triangles[0], v).flatIndex(),
                  cornerAt(original, triangles[1], v).flatIndex());
  }
  side_ = sides.roots();
}

void ChartSides::sortCorners(const TriangleMesh& original, const MeshAt& result) {
  const auto forEachCorner = [&](const auto& visit) {
    for (uint32_t t = 0; t < original.triangleCount(); ++t)
      for (uint32_t c = 0; c < 3; ++c)
        if (const uint32_t v = result.vertexOfInput[original.triangles[t][c]]; v != kNone)
          visit(v, Corner(t, c));
  };
  firstCorner_.assign(size_t{result.mesh.vertexCount()} + 1, 0);
  forEachCorner([&](uint32_t v, Corner) { ++firstCorner_[v + 1]; });
  std::partial_sum(firstCorner_.begin(), firstCorner_.end(), firstCorner_.begin());
  corners_.resize(firstCorner_.back());
  std::vector<uint32_t> next(firstCorner_.begin(), firstCorner_.end() - 1);
  forEachCorner([&](uint32_t v, Corner corner) { corners_[next[v]++] = corner; });
}

}  // namespace limber
