#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"
#include "simplify/mirror.h"

namespace limber {

// A mesh whose vertices have images across `plane` (partners[v], itself on it) and whose triangles have them
// once some edges are flipped: quads that have been cut the same way on both sides. Returns per corner (3 * t
// + c) of the mesh with these flips which corner of `mesh` it has been; nothing where flips do not help, as
// for a quad that lies across the plane. Where either of a quad and its image can be flipped, it is the one
// on the side that the normal points away from; none is where a seam runs along its diagonal. O(n log n).
std::vector<uint32_t> matchSplits(const TriangleMesh& mesh, std::span<const uint32_t> partners,
                                  const MirrorPlane& plane, const Charts& charts);

}  // namespace limber
