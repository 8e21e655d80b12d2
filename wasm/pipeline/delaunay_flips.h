#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// Flips inner edges whose opposite angles add up to more than 180 degrees (so that the triangulation becomes
// intrinsic Delaunay there), where the surface is nearly flat before and after and no edge would come twice.
// `fixed`: edges that stay, smaller vertex first, sorted. `partners`: per vertex its mirror image where the
// mesh is its own, else empty: an edge and its image are flipped together, and none that is its own. Faces
// keep their places in the list, and `corners` (one number each) move with the corners of the triangles.
// Deterministic. Returns the number of flips.
uint32_t flipToDelaunay(TriangleMesh& mesh, const std::vector<std::array<uint32_t, 2>>& fixed,
                        std::span<const uint32_t> partners, std::vector<uint32_t>& corners);

}  // namespace limber
