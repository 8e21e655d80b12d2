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

// Points inside the edges, in the order of the triangles: the middle of each, and between it and the ends as
// many as bring neighbours to at most `spacing` > 0, up to 63 in all. An edge with one triangle may have
// every second of them alone, and middles come twice. O(triangles + points).
std::vector<Vec3> sampleEdges(const TriangleMesh& mesh, double spacing);

}  // namespace limber
