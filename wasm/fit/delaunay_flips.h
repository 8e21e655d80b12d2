#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

struct FlipLimits {
  std::span<const std::array<uint32_t, 2>> fixed = {};  // edges that stay: smaller vertex first, sorted
  // partners[v]: the mirror image of vertex v; empty without symmetry. An edge and its image are flipped
  // together, and an edge that is its own image is not flipped.
  std::span<const uint32_t> partners = {};
  double minAngle = 0;         // degrees; no flip creates a smaller one
  double mostLift = HUGE_VAL;  // largest distance between the old and the new edge, in units of the mesh
};

// Flips interior edges whose opposite angles add up to more than 180 degrees, which makes the triangulation
// intrinsic Delaunay there (Bobenko and Springborn 2007). An edge is only flipped if the surface is nearly
// flat before and after the flip and the new edge does not exist yet. Triangles keep their indices, and
// `corners[3 t + c]` moves with corner c of triangle t. Deterministic. Returns the number of flips.
uint32_t flipToDelaunay(TriangleMesh& mesh, const FlipLimits& limits, std::vector<uint32_t>& corners);

}  // namespace limber
