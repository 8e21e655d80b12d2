#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"

namespace limber {

enum class Borders : int32_t {
  Free = 0,   // border vertices stay on the border
  Fixed = 1,  // border vertices stay where they are
};

// What a simplification has to respect besides the surface itself. Every list may be empty, which wishes
// nothing; otherwise it has the size of the mesh it comes with.
//
// FeatureEdges are edges that act like inner borders: borders themselves, seams (at either end the wedges of
// the two triangles differ), edges between two groups, creases, and outlines of pinned sets. Planes through a
// line enter the error as those through a border do. A vertex between exactly two lines of the same kind of
// place moves along them alone; where a line ends, branches or meets a border, the vertex stays where it is.
// FeatureEdges keep their connectivity, so groups and the patches between seams keep their topology.
struct SimplifyConstraints {
  // [3 * t + c]: corners at one vertex with the same number share all their attributes. Wedges that differ at
  // every edge, as those of flat shading, would make every edge a line: leave such attributes out.
  std::span<const uint32_t> wedges{};
  std::span<const uint32_t> groups{};  // [t]: the primitive or material
  std::span<const uint8_t> locked{};   // [v]: not 0: neither moved nor removed
  std::span<const float>
      keep{};  // [v] in [0, 1]: a cost is multiplied by 1 + 99 keep, the larger of its ends'
  // [v]: bit k is set where v is in the k-th set of PinnedVertices. Bits, because each set has an outline of
  // its own, which collapses keep.
  std::span<const uint32_t> pinnedSets{};
  // [wedge * attributeDimension + i], or [v * attributeDimension + i] without wedges: what CostModel adds to
  // the error. Scaled so that a difference of 1 weighs as much as a distance of the bounding diagonal.
  std::span<const float> attributes{};
  // [v]: the vertex that v is the mirror image of, itself on the plane of symmetry; see Mirror. Edges in the
  // plane are lines.
  std::span<const uint32_t> mirror{};
  uint32_t attributeDimension = 0;  // at most kAttributeLimit
  // An edge whose triangles' normals differ by more than this (degrees) is a crease; 0: none is.
  double creaseAngle = 0;
  Borders borders = Borders::Free;

  static constexpr uint32_t kAttributeLimit = 8;
  static constexpr double kKeepFactor = 99;
};

// Throws std::invalid_argument where a list does not fit the mesh or a number is out of its range.
void checkConstraints(const TriangleMesh& mesh, const SimplifyConstraints& constraints);

}  // namespace limber
