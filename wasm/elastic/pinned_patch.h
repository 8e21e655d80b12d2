#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// Splits the edges of triangles that are pinned whole until none is longer than `length`, and pins the new
// vertices. The surface stays as it is and closed; the vertices that were there keep their numbers. So a
// pinned face is held all over, however few corners it has.
void refinePinnedFaces(TriangleMesh& mesh, std::vector<uint32_t>& pinned, double length);

}  // namespace limber
