#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// The triangles to flip so that neighbours are consistent: the two triangles of an edge must traverse it in
// opposite directions.
struct Orientation {
  std::vector<uint8_t> flipped;  // per triangle: 1 if it has to be flipped
  uint32_t flippedCount = 0;
  bool orientable = true;  // false if a patch cannot be made consistent (a Moebius strip, say)
};

// A patch is a set of triangles joined across edges with exactly two triangles. The smaller side of each
// patch is flipped; on a tie the side of its first triangle stays. A patch that is not orientable is left
// unchanged. Whole bodies are not flipped, so closed bodies need not be wound outwards. O(triangles).
Orientation orient(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
