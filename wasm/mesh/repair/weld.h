#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

struct WeldOptions {
  // Vertices closer than this are welded, in % of the diagonal of the bounding box of the referenced
  // vertices; with 0 only bitwise equal float32 positions (-0 counts as 0). A chain of close vertices becomes
  // a single vertex, however long it is, at the position of its lowest vertex.
  double tolerance = 0;
  // Counts duplicate faces but leaves them in the mesh, where they make edges with more than two faces. For a
  // report of the unchanged file, not for work on the body.
  bool keepDuplicates = false;
};

// The welded body, and the source of its vertices and triangles.
struct WeldResult {
  TriangleMesh mesh;  // without unreferenced vertices, degenerate or duplicate triangles
  // Per source vertex its vertex in `mesh`, or kNone if no usable face refers to it.
  std::vector<uint32_t> vertexOfSource;
  std::vector<uint32_t> sourceOfTriangle;  // per triangle of `mesh` its index in the source
  uint32_t weldedVertices = 0;             // referenced source vertices that were welded to another
  uint32_t degenerateFaces = 0;            // left out: a vertex occurs twice
  uint32_t duplicateFaces = 0;  // left out: the same three vertices as an earlier face, in any order
  // Faces flipped so that neighbours are consistent (the smaller side of each patch, see `orient`): their
  // second and third corners are swapped.
  uint32_t flippedFaces = 0;
};

// Welds a triangle soup into a TriangleMesh. positions[3 * v + c], indices[3 * t + corner].
// Vertices are in the order of their lowest source vertex, triangles in the order of the source. A closed
// body is wound consistently but never flipped as a whole, so its faces need not look outwards. A soup
// without any usable face gives an empty result. Throws std::invalid_argument with a sentence if an index is
// out of range, a referenced position is not finite or the tolerance is not a number >= 0. Throws Cancelled.
// O(n log n) but for large tolerances, see uniteCloseVertices.
WeldResult weld(std::span<const float> positions, std::span<const uint32_t> indices,
                const WeldOptions& options, Job& job);

}  // namespace limber
