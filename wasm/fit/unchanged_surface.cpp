#include "fit/unchanged_surface.h"

#include <algorithm>

namespace limber {

std::vector<uint8_t> findUnchangedTriangles(const TriangleMesh& original, const MeshAt& result) {
  std::vector<uint8_t> isUnchanged(result.mesh.triangleCount());
  for (uint32_t t = 0; t < result.mesh.triangleCount(); ++t) {
    const uint32_t input = result.inputOfTriangle[t];
    isUnchanged[t] = 1;
    for (int corner = 0; corner < 3; ++corner)
      isUnchanged[t] &= result.mesh.corner(t, corner) == original.corner(input, corner);
  }
  return isUnchanged;
}

void keepUnchanged(FitPart& part, const Topology& topology, const std::vector<uint8_t>& isUnchanged) {
  const auto isKept = [&](uint32_t t) { return isUnchanged[part.wholeTriangle[t]] != 0; };
  for (uint32_t v = 0; v < part.result.vertexCount(); ++v)
    if (std::ranges::any_of(topology.trianglesAround(v), isKept)) part.lock(v);
  for (const Topology::Edge& edge : topology.edges)
    if (std::ranges::any_of(topology.trianglesAt(edge), isKept)) part.fixedEdges.push_back({edge.a, edge.b});
  std::ranges::sort(part.fixedEdges);
}

}  // namespace limber
