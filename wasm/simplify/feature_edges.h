#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/constraints.h"

namespace limber {

// What may happen to a vertex. Of the two ends of a collapse, the one whose role comes later in this list is
// kept.
enum class Freedom : uint8_t {
  Free,     // inside the surface
  Feature,  // on feature edges (see SimplifyConstraints), on which it stays
  Fixed,    // neither moved nor removed, but others may collapse into it
  Locked,   // non-manifold, at a non-manifold edge, or where windings clash; none of its edges collapses
};

// The properties of a vertex that collapses need.
struct VertexRole {
  Freedom freedom = Freedom::Free;
  bool onFeature = false;  // one of its edges is a feature edge, borders included
  bool onBorder = false;   // one of its edges is a border
};

// The kind of an edge with two triangles.
enum class FeatureKind : uint8_t {
  None,
  Seam,     // only wedges differ: the texture continues in another chart
  Outline,  // any other feature edge
};

// The feature edges of a mesh, and the roles of its vertices that follow from these and the constraints.
struct FeatureEdges {
  std::vector<FeatureKind> kinds;  // [e]; borders have None
  std::vector<VertexRole> roles;   // [v]

  bool isFeature(size_t edge) const { return kinds[edge] != FeatureKind::None; }
};

// O(triangles). `constraints` must have been checked.
FeatureEdges findFeatureEdges(const TriangleMesh& mesh, const Topology& topology,
                              const SimplifyConstraints& constraints);

}  // namespace limber
