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
  uint32_t firstTip, secondTip;      // 0, 1 or 2: their corners at `left` and `right`
  uint32_t left, start, end, right;  // vertices
};

// Nothing where an edge has not exactly two triangles that run it opposite ways, with different tips.
std::optional<EdgeQuad> quadAt(const TriangleMesh& mesh, const Topology& topology,
                               const Topology::Edge& edge);

// The triangles become (left, start, right) and (left, right, end); so do their corners: corners[3 * t + c]
// is what corner c of triangle t has been.
void flipEdge(const EdgeQuad& quad, TriangleMesh& mesh, std::vector<uint32_t>& corners);

}  // namespace limber
