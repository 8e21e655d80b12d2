#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// `count` points spread evenly by area over the surface, by a fixed low-discrepancy sequence: stratified
// along the triangles' cumulated area, then a Fibonacci-like pair inside the triangle. Empty for a surface
// without area.
std::vector<Vec3> sampleSurface(const TriangleMesh& mesh, uint32_t count);

}  // namespace limber
