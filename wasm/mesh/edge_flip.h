#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The two triangles (left, start, end) and (right, end, start) of an edge.
struct EdgeQuad {
  uint32_t first, second;            // triangles
  uint32_t firstTip, secondTip;      // 0, 1 or 2: indices of their corners at `left` and `right`
  uint32_t left, start, end, right;  // vertices
};

// The triangles of an edge; none unless the edge has exactly two, which traverse it in opposite directions
// and have different tips.
std::optional<EdgeQuad> quadAt(const TriangleMesh& mesh, const Topology& topology,
                               const Topology::Edge& edge);

// Flips the edge: the triangles become (left, start, right) and (left, right, end). `corners` is permuted in
// the same way: corners[3 * t + c] is the flat index of the corner that corner c of triangle t was before all
// flips.
void flipEdge(const EdgeQuad& quad, TriangleMesh& mesh, std::vector<uint32_t>& corners);

}  // namespace limber
