#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

struct SurfaceSamples {
  std::vector<Vec3> positions;
  std::vector<uint32_t> triangles;  // per position the triangle that it lies in
};

// `count` points that are spread evenly over the area of the surface: stratified along the cumulated area of
// the triangles, then by a fixed low-discrepancy sequence inside each triangle. Empty for a surface without
// area. O(triangles + count).
SurfaceSamples sampleSurface(const TriangleMesh& mesh, uint32_t count);

}  // namespace limber
