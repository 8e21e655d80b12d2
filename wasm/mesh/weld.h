#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

struct WeldOptions {
  // Vertices closer than this become one, in % of the diagonal of the referenced vertices' bounding box; 0:
  // only bitwise equal float32 positions (-0 counts as 0). Being one carries over from pair to pair, so that
  // a chain of close vertices becomes one however long it is; it stands where its lowest vertex stood.
  double tolerance = 0;
  // Counts duplicate faces but leaves them in the mesh (where they make edges with more than two faces): for
  // a report of the file as it is, not for work on the body.
  bool keepDuplicates = false;
};

// A body ready for everything else, and where its parts came from.
struct WeldResult {
  TriangleMesh mesh;  // without unreferenced vertices, degenerate or duplicate triangles
  std::vector<uint32_t>
      vertexOfSource;  // per source vertex its vertex in `mesh`, or kNone where no usable face needs it
  std::vector<uint32_t> sourceOfTriangle;  // per triangle of `mesh` its index in the source
  uint32_t weldedVertices = 0;             // referenced source vertices that became one with another
  uint32_t degenerateFaces = 0;            // set aside: a repeated vertex
  uint32_t duplicateFaces = 0;  // set aside: the same three vertices as an earlier face, in any order
  uint32_t flippedFaces = 0;    // turned so that neighbours agree (the smaller part of each component is);
                                // a turned face has its second and third corner swapped
};

// Welds a triangle soup into a TriangleMesh. positions[3 * v + c], indices[3 * t + corner].
// Vertices come in the order of their lowest source vertex, triangles in the order of the source. A closed
// body is wound consistently but not turned inside out: that its faces look outwards is not promised.
// Throws std::invalid_argument with a sentence where an index is out of range, a referenced position is not
// finite or the tolerance is not a number >= 0; and Cancelled. A soup without any usable face is no error
// here: the result is empty.
WeldResult weld(std::span<const float> positions, std::span<const uint32_t> indices,
                const WeldOptions& options, Job& job);

}  // namespace limber
