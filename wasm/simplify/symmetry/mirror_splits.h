#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"
#include "simplify/symmetry/mirror.h"

namespace limber {

// Flips edges so that each triangle of a mesh has an image across `plane` although quads were split in the
// same direction on both sides; partners[v] is the image of vertex v, v itself on the plane. Returns per
// corner (3 * t + c) of the mesh with these flips the flat index of the corner of `mesh` that it was; empty
// if flips do not suffice, as for a quad that lies across the plane. Of a quad and its image, the one on the
// side that the normal points away from is flipped if possible. Diagonals along seams are not flipped. O(n
// log n).
std::vector<uint32_t> matchSplits(const TriangleMesh& mesh, std::span<const uint32_t> partners,
                                  const MirrorPlane& plane, const Charts& charts);

}  // namespace limber
