#include "mesh/orientation.h"

#include <algorithm>

namespace limber {
namespace {

// Whether triangle t runs the edge from its smaller vertex to its larger one.
bool runsForward(const Triangle& triangle, const Topology::Edge& edge) {
  for (int c = 0; c < 3; ++c)
    if (triangle[c] == edge.a) return triangle[(c + 1) % 3] == edge.b;
  return false;
}

// One patch: its triangles in the order in which they were reached, the first being the lowest.
struct Patch {
  std::vector<uint32_t> triangles;
  bool orientable = true;
};

constexpr uint8_t kUnseen = 2;

// Spreads from triangle `first` over edges with two triangles; side[t] becomes 0 where t agrees with `first`,
// else 1.
Patch spread(const TriangleMesh& mesh, const Topology& topology, uint32_t first, std::vector<uint8_t>& side) {
  Patch patch;
  patch.triangles.push_back(first);
  side[first] = 0;
  for (size_t i = 0; i < patch.triangles.size(); ++i) {
    const uint32_t t = patch.triangles[i];
    for (int c = 0; c < 3; ++c) {
      const Topology::Edge& edge = topology.edges[topology.edgeOfCorner[3 * t + c]];
      if (edge.useCount != 2) continue;
      const auto sharing = topology.trianglesAt(edge);
      const uint32_t neighbour = sharing[sharing[0] == t ? 1 : 0];
      const uint8_t expected = side[t] ^ static_cast<uint8_t>(isClash(mesh, topology, edge));
      if (side[neighbour] == kUnseen) {
        side[neighbour] = expected;
        patch.triangles.push_back(neighbour);
      }
      patch.orientable &= side[neighbour] == expected;
    }
  }
  return patch;
}

}  // namespace

bool isClash(const TriangleMesh& mesh, const Topology& topology, const Topology::Edge& edge) {
  if (edge.useCount != 2) return false;
  const auto sharing = topology.trianglesAt(edge);
  return runsForward(mesh.triangles[sharing[0]], edge) == runsForward(mesh.triangles[sharing[1]], edge);
}

Orientation orient(const TriangleMesh& mesh, const Topology& topology) {
  Orientation orientation;
  std::vector<uint8_t> side(mesh.triangleCount(), kUnseen);
  orientation.turned.assign(mesh.triangleCount(), 0);
  for (uint32_t first = 0; first < mesh.triangleCount(); ++first) {
    if (side[first] != kUnseen) continue;
    const Patch patch = spread(mesh, topology, first, side);
    orientation.orientable &= patch.orientable;
    if (!patch.orientable) continue;
    const auto others =
        static_cast<size_t>(std::ranges::count_if(patch.triangles, [&](uint32_t t) { return side[t] == 1; }));
    const uint8_t minority = 2 * others > patch.triangles.size() ? 0 : 1;
    for (uint32_t t : patch.triangles) orientation.turned[t] = side[t] == minority;
  }
  orientation.turnedCount = static_cast<uint32_t>(std::ranges::count(orientation.turned, 1));
  return orientation;
}

}  // namespace limber
