#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

struct FlipLimits {
  std::span<const std::array<uint32_t, 2>> fixed = {};  // edges that stay, smaller vertex first, sorted
  // Per vertex its mirror image where the mesh is its own, else empty: an edge and its image are flipped
  // together, and none that is its own.
  std::span<const uint32_t> partners = {};
  double minAngle = 0;         // degrees: no smaller one comes into being
  double mostLift = HUGE_VAL;  // by how far the surface may move: the distance between old and new edge
};

// Flips inner edges whose opposite angles add up to more than 180 degrees (so that the triangulation becomes
// intrinsic Delaunay there), where the surface is nearly flat before and after and no edge would come twice.
// Faces keep their places in the list, and `corners` (one number each) move with the corners of the
// triangles. Deterministic. Returns the number of flips.
uint32_t flipToDelaunay(TriangleMesh& mesh, const FlipLimits& limits, std::vector<uint32_t>& corners);

}  // namespace limber
