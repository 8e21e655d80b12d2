#pragma once

#include "simplify/collapse_mesh.h"

namespace limber {

// Calls visit(q, r) with the two corners that stay in place, for every triangle that the collapse of an edge
// changes without removing it.
template <class Visit>
void forEachChangedTriangle(const CollapseMesh& mesh, uint32_t edge, const Visit& visit) {
  const auto [a, b] = mesh.edge(edge);
  for (const uint32_t v : {a, b})
    for (const Corner corner : mesh.star(v)) {
      const auto& [vertices, edges] = mesh.face(corner.triangle());
      const int next = nextIndex(corner.index()), previous = previousIndex(corner.index());
      if (edges[next] == edge || edges[previous] == edge) continue;
      visit(mesh.position(vertices[next]), mesh.position(vertices[previous]));
    }
}

}  // namespace limber
