#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"

namespace limber {

enum class Borders : int32_t {
  Free = 0,   // border vertices stay on the border
  Fixed = 1,  // border vertices do not move
};

// The constraints that a simplification has to respect in addition to the surface itself. An empty list
// constrains nothing; otherwise its size matches the mesh.
//
// Feature edges are borders and the edges that act like interior borders: seams (at either end the wedges of
// the two triangles differ), edges between two groups, creases, outlines of pinned sets and edges in the
// plane of symmetry. Planes through all of them enter the error. A vertex with exactly two feature edges,
// both borders or both interior, only moves along them; a vertex where feature edges end, branch or meet a
// border does not move. Feature edges keep their connectivity, so groups and the patches between seams keep
// their topology.
struct SimplifyConstraints {
  // [3 * t + c]: corners at one vertex with the same number share all their attributes. Omit attributes that
  // differ at every edge, such as flat normals, because they would make every edge a feature edge.
  std::span<const uint32_t> wedges{};
  std::span<const uint32_t> groups{};  // [t]: the primitive or material
  std::span<const uint8_t> locked{};   // [v]: nonzero if the vertex is neither moved nor removed
  // [v], in [0, 1]: keep weights. The cost of an edge is multiplied by 1 + 99 times the larger one of its
  // ends.
  std::span<const float> keep{};
  // [v]: bit k is set if v is in the k-th set of PinnedVertices. One bit for each set, because collapses
  // preserve the outline of each.
  std::span<const uint32_t> pinnedSets{};
  // [wedge * attributeDimension + i], or [v * attributeDimension + i] without wedges: attributes that count
  // in the error, see AttributeQuadrics. A difference of 1 weighs as much as a distance of one diagonal.
  std::span<const float> attributes{};
  // [t], in [0, 1]: the factor on the error of texture coordinates, the first two attributes, and on the
  // weight of a seam next to the triangle. Empty: 1.
  std::span<const float> textureWeights{};
  // [v]: the vertex that v is the mirror image of, v itself on the plane of symmetry; see Mirror.
  std::span<const uint32_t> mirror{};
  uint32_t attributeDimension = 0;  // at most kAttributeLimit
  // The last 3 * displacementFields of the attributes are coordinates of displacements. Only the component of
  // their error across the surface counts.
  uint32_t displacementFields = 0;
  // An edge is a crease if the normals of its triangles differ by more than this angle; degrees, in [0, 180].
  // 0: no edge is.
  double creaseAngle = 0;
  Borders borders = Borders::Free;

  static constexpr uint32_t kAttributeLimit = 8;
  static constexpr double kKeepFactor = 99;  // see `keep`
};

// Throws std::invalid_argument if a list does not fit the mesh or a number is out of its range.
void checkConstraints(const TriangleMesh& mesh, const SimplifyConstraints& constraints);

}  // namespace limber
