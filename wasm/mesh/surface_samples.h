#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

struct SurfaceSamples {
  std::vector<Vec3> positions;
  std::vector<uint32_t> triangles;  // per position the triangle that contains it
};

// `count` points that are spread evenly over the area of the surface: stratified along the cumulated area of
// the triangles, then by a fixed low-discrepancy sequence inside each triangle. Empty for a surface without
// area. O(triangles + count).
SurfaceSamples sampleSurface(const TriangleMesh& mesh, uint32_t count);

// Points inside the edges, in the order of the triangles: the midpoint of each, and as many on both sides of
// it as it takes for a spacing of at most `spacing` > 0, up to 63 in all. Each of the two triangles of an
// edge contributes half of these points and the midpoint, which therefore occurs twice; an edge with one
// triangle may have only one half. O(triangles + points).
std::vector<Vec3> sampleEdges(const TriangleMesh& mesh, double spacing);

}  // namespace limber
