#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"

namespace limber {

inline constexpr int kAnyAxis = -1;

// The mirror symmetry of a mesh, or how far it is from one.
struct MirrorImages {
  std::vector<uint32_t> partners;  // as SimplifyConstraints::mirror; empty where there is no symmetry
  // Where it is symmetric once quads are cut the other way: see matchSplits. Empty where it is as it stands.
  std::vector<uint32_t> corners;
  // Of the plane asked for, or of the nearest to a symmetry among those tried.
  uint32_t asymmetricVertices = 0;   // they have no image
  uint32_t asymmetricTriangles = 0;  // nor have they, as the mesh stands; not counted where vertices stray
};

// Looks for a plane through the centre of the vertices that a mesh is symmetric to, vertices (to 5e-5 of the
// diagonal) and triangles: normal to axis 0, 1 or 2; with kAnyAxis to these in turn, then to the principal
// axes, the longest first; rather one to which it is symmetric as it stands than one that takes other cuts.
// Other planes are not found. O(n log n). Throws Cancelled.
MirrorImages findMirrorImages(const TriangleMesh& mesh, const Charts& charts, int axis, Job& job);

}  // namespace limber
