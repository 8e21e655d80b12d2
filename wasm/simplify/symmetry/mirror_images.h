#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"

namespace limber {

inline constexpr int kAnyAxis = -1;

// The mirror symmetry of a mesh, or the counts of what breaks it.
struct MirrorImages {
  std::vector<uint32_t> partners;  // as SimplifyConstraints::mirror; empty without symmetry
  // For a mesh that is symmetric once some quads are split along their other diagonals: per corner (3 * t +
  // c) the flat index of the corner that it was, see matchSplits. Empty if no quad needs that.
  std::vector<uint32_t> corners;
  // Counts for the given plane, or for the plane nearest to a symmetry among those tried.
  uint32_t asymmetricVertices = 0;   // without an image
  uint32_t asymmetricTriangles = 0;  // the same, as quads are split; not counted if vertices are asymmetric
};

// Looks for a plane through the centre of the vertices about which a mesh is symmetric, in its vertices (to
// 5e-5 of the diagonal) and its triangles. The plane is normal to axis 0, 1 or 2; with kAnyAxis these are
// tried one after the other, then the principal axes, the longest first. A plane for which no quad has to be
// split differently is preferred. Other planes are not found. O(n log n). Throws Cancelled.
MirrorImages findMirrorImages(const TriangleMesh& mesh, const Charts& charts, int axis, Job& job);

}  // namespace limber
