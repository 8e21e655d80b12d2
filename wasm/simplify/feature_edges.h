#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/constraints.h"

namespace limber {

// What may happen to a vertex. Of two that collapse, the one that comes later in this list is kept.
enum class Freedom : uint8_t {
  Free,     // inside the surface
  Feature,  // on feature edges (see SimplifyConstraints), and it stays on them
  Fixed,    // neither moved nor removed, but others may collapse into it
  Locked,   // at a non-manifold vertex or edge, or where windings clash; none of its edges collapses
};

// What a collapse needs to know of a vertex.
struct VertexRole {
  Freedom freedom = Freedom::Free;
  bool onFeature = false;  // one of its edges is a feature edge, borders included
  bool onBorder = false;   // one of its edges is a border
};

// What an edge with two triangles is.
enum class FeatureKind : uint8_t {
  None,
  Seam,     // wedges differ and nothing else: the texture goes on in another piece of it
  Outline,  // any other feature edge
};

// The feature edges of a mesh, and what these and the constraints allow its vertices.
struct FeatureEdges {
  std::vector<FeatureKind> kinds;  // [e]; borders have None
  std::vector<VertexRole> roles;   // [v]

  bool isFeature(size_t edge) const { return kinds[edge] != FeatureKind::None; }
};

// O(triangles). `constraints` must have been checked.
FeatureEdges findFeatureEdges(const TriangleMesh& mesh, const Topology& topology,
                              const SimplifyConstraints& constraints);

}  // namespace limber
