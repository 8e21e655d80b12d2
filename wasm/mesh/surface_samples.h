#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

struct SurfaceSamples {
  std::vector<Vec3> positions;
  std::vector<uint32_t> triangles;  // that each lies in
};

// `count` points spread evenly by area over the surface, by a fixed low-discrepancy sequence: stratified
// along the triangles' cumulated area, then a Fibonacci-like pair inside the triangle. Empty for a surface
// without area.
SurfaceSamples sampleSurface(const TriangleMesh& mesh, uint32_t count);

}  // namespace limber
