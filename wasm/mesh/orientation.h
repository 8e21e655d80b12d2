#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"

namespace limber {

// Which triangles to turn so that neighbours agree: the two triangles of an edge must run it in opposite
// directions.
struct Orientation {
  std::vector<uint8_t> flipped;  // per triangle: 1 where it has to be flipped
  uint32_t flippedCount = 0;
  bool orientable = true;  // false where some patch cannot be made to agree (a Moebius strip, say)
};

// Works patch by patch, a patch being triangles joined across edges with exactly two triangles. In each the
// smaller side is flipped; on a tie the side of the patch's first triangle stays. A patch that is not
// orientable is left as it is. Nothing is flipped inside out as a whole: that closed bodies are wound
// outwards is not promised. O(triangles).
Orientation orient(const TriangleMesh& mesh, const Topology& topology);

}  // namespace limber
