#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// Where on the input the attributes of each corner of a result come from.
struct CornerSources {
  std::vector<uint32_t> triangle;  // per corner 3 * t + c of the result: a triangle of the input
  std::vector<float> barycentric;  // barycentric[3 * corner + c] on it, each in [0, 1], the sum is 1
};

// An edge is a seam where its two triangles differ in group, or in wedge at either end, or where it has not
// exactly two triangles. The input triangles around all the vertices that became one vertex of the result
// fall into sides along the seams; a corner of the result belongs to the side of its own triangle
// (result.inputOfTriangle) and has its source there, so that nothing bleeds over a seam:
// - a vertex that has stayed alone and in place: each corner is its own source, (1, 0, 0) and so on;
// - a side without a seam: the closest point, also beyond the side as long as no seam is crossed;
// - a vertex on a seam: the closest point of that seam, the same one for both sides, so that they meet in
// place;
// - a vertex where seams meet or end: the closest input vertex where they do.
// Corners that share vertex and side have the same source. Throws Cancelled, and std::invalid_argument where
// `charts` or `result` do not fit the input.
CornerSources sourceOfCorners(const TriangleMesh& input, const Charts& charts, const MeshAt& result,
                              Job& job);

}  // namespace limber
