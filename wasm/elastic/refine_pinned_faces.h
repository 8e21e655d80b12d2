#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// Splits the edges of triangles whose three vertices are pinned until none is longer than `length`, and pins
// the new vertices, so that the whole of a pinned face is fixed, however few vertices it has. The surface
// keeps its shape and stays closed; old vertices keep their ids, new ones are appended to `mesh` and
// `pinned`.
//
// `parents`, if given, receives for each new vertex the two vertices whose midpoint it is; they have smaller
// ids.
void refinePinnedFaces(TriangleMesh& mesh, std::vector<uint32_t>& pinned, double length,
                       std::vector<std::array<uint32_t, 2>>* parents = nullptr);

}  // namespace limber
