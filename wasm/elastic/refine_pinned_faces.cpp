#include "elastic/refine_pinned_faces.h"

#include <algorithm>

#include "mesh/topology.h"

namespace limber {

namespace {

// Adds a vertex at the midpoint of each long edge of a pinned triangle. Returns the middle vertex per edge,
// or kNone.
std::vector<uint32_t> splitLongEdges(TriangleMesh& mesh, const Topology& topology,
                                     std::vector<uint8_t>& isPinned, double length) {
  std::vector<uint32_t> middle(topology.edges.size(), kNone);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle triangle = mesh.triangles[t];
    if (!std::all_of(triangle.begin(), triangle.end(), [&](uint32_t v) { return isPinned[v]; })) continue;
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t e = topology.edgeOpposite(Corner(t, c));
      const auto& edge = topology.edges[e];
      const Vec3 a = mesh.positions[edge.a], b = mesh.positions[edge.b];
      if (middle[e] != kNone || limber::length(b - a) <= length) continue;
      middle[e] = mesh.vertexCount();
      mesh.positions.push_back((a + b) * 0.5);
      isPinned.push_back(1);
    }
  }
  return middle;
}

// For the vertices from `before` on, appends the ends of the edges whose midpoints they are.
void addParents(const Topology& topology, const std::vector<uint32_t>& middle, uint32_t before,
                std::vector<std::array<uint32_t, 2>>& parents) {
  const size_t first = parents.size();
  for (uint32_t e = 0; e < middle.size(); ++e) {
    if (middle[e] == kNone) continue;
    parents.resize(std::max(parents.size(), first + middle[e] - before + 1));
    parents[first + middle[e] - before] = {topology.edges[e].a, topology.edges[e].b};
  }
}

// Appends the pieces of a triangle with no, one, two or three split edges, with the winding of the triangle.
// middle[c] is the middle vertex of the edge opposite to corner c, or kNone.
void addPieces(const Triangle& triangle, std::array<uint32_t, 3> middle, std::vector<Triangle>& pieces) {
  const auto count = std::count_if(middle.begin(), middle.end(), [](uint32_t m) { return m != kNone; });
  // Start at the corner opposite to the only split edge, or to the only unsplit one.
  size_t first = 0;
  while (count % 3 != 0 && (middle[first] != kNone) != (count == 1)) ++first;
  const uint32_t a = triangle[first], b = triangle[(first + 1) % 3], c = triangle[(first + 2) % 3];
  const uint32_t bc = middle[first], ca = middle[(first + 1) % 3], ab = middle[(first + 2) % 3];
  if (count == 0) pieces.push_back({a, b, c});
  if (count == 1) pieces.insert(pieces.end(), {{a, b, bc}, {a, bc, c}});
  if (count == 2) pieces.insert(pieces.end(), {{a, ab, ca}, {ab, b, c}, {ab, c, ca}});
  if (count == 3) pieces.insert(pieces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
}

}  // namespace

void refinePinnedFaces(TriangleMesh& mesh, std::vector<uint32_t>& pinned, double length,
                       std::vector<std::array<uint32_t, 2>>* parents) {
  std::vector<uint8_t> isPinned(mesh.vertexCount(), 0);
  for (uint32_t v : pinned) isPinned[v] = 1;
  for (;;) {
    const Topology topology = buildTopology(mesh);
    const uint32_t before = mesh.vertexCount();
    const std::vector<uint32_t> middle = splitLongEdges(mesh, topology, isPinned, length);
    if (mesh.vertexCount() == before) return;
    for (uint32_t v = before; v < mesh.vertexCount(); ++v) pinned.push_back(v);
    if (parents) addParents(topology, middle, before, *parents);
    std::vector<Triangle> pieces;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      const auto middleOpposite = [&](uint32_t c) { return middle[topology.edgeOpposite(Corner(t, c))]; };
      addPieces(mesh.triangles[t], {middleOpposite(0), middleOpposite(1), middleOpposite(2)}, pieces);
    }
    mesh.triangles = std::move(pieces);
  }
}

}  // namespace limber
