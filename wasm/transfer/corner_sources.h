#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// The points of an original from which the corners of a result take their attributes.
struct CornerSources {
  std::vector<uint32_t> triangle;  // for corner [3 t + c] of the result: a triangle of the original
  std::vector<float> barycentric;  // [3 corner + k]: of that triangle, each in [0, 1] with sum 1
};

// Finds the source of every corner of a result, so that no attribute bleeds over a seam. An edge is a seam if
// its two triangles differ in group, or in wedge at either end, or if it does not have exactly two triangles.
// Seams divide the triangles of the original around the vertices that were merged into one vertex of the
// result into sides (ChartSides); a corner of the result belongs to the side of its own triangle
// (result.inputOfTriangle) and has its source there:
// - at a vertex that has not moved and into which no other vertex was merged, each corner is its own source;
// - on a side without a seam, the source is the closest point that is reachable without crossing a seam,
// which may lie beyond the side;
// - at a vertex on a seam, the source is the closest point of that seam, which both sides share, so that they
//   meet there;
// - at a vertex where seams meet or end, the source is the closest vertex of the original where seams meet or
// end. Corners that share vertex and side have the same source. Throws Cancelled, and std::invalid_argument
// if `charts` or `result` does not fit the original.
CornerSources sourceOfCorners(const TriangleMesh& original, const Charts& charts, const MeshAt& result,
                              Job& job);

}  // namespace limber
