#include "mesh/repair/orientation.h"

#include <algorithm>

namespace limber {
namespace {

// The triangles of one patch in the order in which they were found; the first is the lowest.
struct Patch {
  std::vector<uint32_t> triangles;
  bool orientable = true;
};

constexpr uint8_t kUnseen = 2;

// Finds the patch of triangle `first` across edges with two triangles; side[t] becomes 0 if the orientation
// of t agrees with `first`, else 1.
Patch spread(const Topology& topology, uint32_t first, std::vector<uint8_t>& side) {
  Patch patch;
  patch.triangles.push_back(first);
  side[first] = 0;
  for (size_t i = 0; i < patch.triangles.size(); ++i) {
    const uint32_t t = patch.triangles[i];
    for (int c = 0; c < 3; ++c) {
      const uint32_t e = topology.edgeOpposite(Corner(t, c));
      const auto sharing = topology.trianglesAt(topology.edges[e]);
      if (sharing.size() != 2) continue;
      const uint32_t neighbour = sharing[sharing[0] == t ? 1 : 0];
      const uint8_t expected = side[t] ^ topology.clashes[e];
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

Orientation orient(const TriangleMesh& mesh, const Topology& topology) {
  Orientation orientation;
  std::vector<uint8_t> side(mesh.triangleCount(), kUnseen);
  orientation.flipped.assign(mesh.triangleCount(), 0);
  for (uint32_t first = 0; first < mesh.triangleCount(); ++first) {
    if (side[first] != kUnseen) continue;
    const Patch patch = spread(topology, first, side);
    orientation.orientable &= patch.orientable;
    if (!patch.orientable) continue;
    const auto others =
        static_cast<size_t>(std::ranges::count_if(patch.triangles, [&](uint32_t t) { return side[t] == 1; }));
    const uint8_t minority = 2 * others > patch.triangles.size() ? 0 : 1;
    for (uint32_t t : patch.triangles) orientation.flipped[t] = side[t] == minority;
  }
  orientation.flippedCount = static_cast<uint32_t>(std::ranges::count(orientation.flipped, 1));
  return orientation;
}

}  // namespace limber
