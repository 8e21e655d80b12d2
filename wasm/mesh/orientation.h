#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// Which triangles to turn so that neighbours agree: the two triangles of an edge must run it in opposite
// directions.
struct Orientation {
  std::vector<uint8_t> turned;  // per triangle: 1 where it has to be turned
  uint32_t turnedCount = 0;
  bool orientable = true;  // false where some patch cannot be made to agree (a Moebius strip, say)
};

// Works patch by patch, a patch being triangles joined across edges with exactly two triangles. In each the
// smaller side is turned; on a tie the side of the patch's first triangle stays. A patch that is not
// orientable is left as it is. Nothing is turned inside out as a whole: that closed bodies are wound outwards
// is not promised. O(triangles).
Orientation orient(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
