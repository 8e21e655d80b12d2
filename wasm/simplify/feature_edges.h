#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/constraints.h"

namespace limber {

// What may happen to a vertex; of two that collapse the stronger one, the later in this list, is kept.
enum class Freedom : uint8_t {
  Free,     // inside the surface
  Feature,  // on a feature edge (see SimplifyConstraints): it stays on it
  Fixed,    // neither moved nor removed, but others may collapse into it
  Locked,   // at a non-manifold vertex or edge, or where windings clash: no edge of it collapses
};

// What a vertex is for a collapse.
struct VertexRole {
  Freedom freedom = Freedom::Free;
  bool onFeature = false;  // an edge of it is a line
  bool onBorder = false;   // an edge of it is a border
};

// The lines of a mesh and what they, and the constraints, let its vertices do.
struct FeatureEdges {
  std::vector<uint8_t> isFeature;  // [e]: 1 on an edge with two triangles that is a line; borders have 0
  std::vector<VertexRole> roles;   // [v]
};

// O(triangles). `wishes` must have been checked.
FeatureEdges findFeatureEdges(const TriangleMesh& mesh, const Topology& topology,
                              const SimplifyConstraints& constraints);

}  // namespace limber
