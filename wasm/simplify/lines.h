#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/wishes.h"

namespace limber {

// What may happen to a vertex; of two that collapse the stronger one, the later in this list, is kept.
enum class Freedom : uint8_t {
  Free,      // inside the surface
  Line,      // on a border or another line (see Wishes): it stays on it
  Anchored,  // neither moved nor removed, but others may collapse into it
  Locked,    // at a non-manifold vertex or edge, or where windings clash: no edge of it collapses
};

// What a vertex is for a collapse.
struct VertexRole {
  Freedom freedom = Freedom::Free;
  bool onLine = false;    // an edge of it is a line
  bool onBorder = false;  // an edge of it is a border
};

// The lines of a mesh and what they, and the wishes, let its vertices do.
struct Lines {
  std::vector<uint8_t> isLine;    // [e]: 1 on an edge with two triangles that is a line; borders have 0
  std::vector<VertexRole> roles;  // [v]
};

// O(triangles). `wishes` must have been checked.
Lines findLines(const TriangleMesh& mesh, const Topology& topology, const Wishes& wishes);

}  // namespace limber
