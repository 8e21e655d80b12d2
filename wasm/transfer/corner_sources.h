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
  std::vector<uint32_t> triangle;  // [3 t + c] for corner c of triangle t of the result: of the original
  std::vector<float> barycentric;  // [3 corner + k]: of that triangle, each in [0, 1] with sum 1
};

// Finds the source of every corner of a result, so that no attribute bleeds over a seam. An edge is a seam
// where its two triangles differ in group, or in wedge at either end, or where it has not exactly two
// triangles. The triangles of the original around the vertices that became one vertex of the result fall into
// sides along the seams (ChartSides); a corner of the result belongs to the side of its own triangle
// (result.inputOfTriangle) and has its source there:
// - at a vertex that no other vertex was merged into and that has not moved, each corner is its own source;
// - on a side without a seam, the source is the closest point that is reached without crossing a seam, which
//   may lie beyond the side;
// - at a vertex on a seam, the source is the closest point of that seam, which both sides share, so that they
//   meet there;
// - at a vertex where seams meet or end, the source is the closest vertex of the original where they do.
// Corners that share vertex and side have the same source. Throws Cancelled, and std::invalid_argument where
// `charts` or `result` do not fit the original.
CornerSources sourceOfCorners(const TriangleMesh& original, const Charts& charts, const MeshAt& result,
                              Job& job);

}  // namespace limber
