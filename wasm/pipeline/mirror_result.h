#pragma once

#include <cstdint>
#include <span>

#include "pipeline/corner_sources.h"
#include "simplify/history.h"

namespace limber {

// What a result is mirrored by.
struct MirrorRequest {
  std::span<const uint32_t> partners;  // per vertex of the input, see Wishes::mirror
  Charts charts = {};
  std::span<const uint8_t> locked = {};  // per vertex of the input: it stays where it is; may be empty
};

// `fitted`, which came from `reduced` by moving vertices and flipping edges, made its own mirror image again,
// as `reduced` is: each vertex goes halfway to the image of its partner, or to the plane; flips on the side
// that the plane's normal points to are repeated on the other side, unless a seam is in their way there, and
// flips across the plane are taken back. Returns `reduced` where a face would turn over. Throws
// std::invalid_argument where `reduced` is not its own mirror image or does not belong to `fitted`.
MeshAt mirrorResult(const TriangleMesh& input, const MeshAt& reduced, const MeshAt& fitted,
                    const MirrorRequest& request);

}  // namespace limber
