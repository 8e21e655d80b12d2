#include "mesh/edge_flip.h"

#include <array>

namespace limber {

std::optional<EdgeQuad> quadAt(const TriangleMesh& mesh, const Topology& topology,
                               const Topology::Edge& edge) {
  if (edge.useCount != 2) return std::nullopt;
  const auto uses = topology.trianglesAt(edge);
  const Triangle &first = mesh.triangles[uses[0]], &second = mesh.triangles[uses[1]];
  const auto tipOf = [&](const Triangle& t) {
    uint32_t c = 0;
    while (c < 3 && (t[c] == edge.a || t[c] == edge.b)) ++c;
    return c;
  };
  const uint32_t c = tipOf(first), d = tipOf(second);
  if (c == 3 || d == 3) return std::nullopt;
  const EdgeQuad quad{uses[0], uses[1], c, d, first[c], first[(c + 1) % 3], first[(c + 2) % 3], second[d]};
  if (second[(d + 1) % 3] != quad.end || quad.left == quad.right) return std::nullopt;
  return quad;
}

void flipEdge(const EdgeQuad& quad, TriangleMesh& mesh, std::vector<uint32_t>& corners) {
  mesh.triangles[quad.first] = {quad.left, quad.start, quad.right};
  mesh.triangles[quad.second] = {quad.left, quad.right, quad.end};
  uint32_t *const of = &corners[3 * size_t{quad.first}], *const other = &corners[3 * size_t{quad.second}];
  const uint32_t left = of[quad.firstTip], start = of[(quad.firstTip + 1) % 3],
                 end = of[(quad.firstTip + 2) % 3], right = other[quad.secondTip];
  const std::array<uint32_t, 3> now = {left, start, right}, then = {left, right, end};
  for (size_t k = 0; k < 3; ++k) {
    of[k] = now[k];
    other[k] = then[k];
  }
}

}  // namespace limber
