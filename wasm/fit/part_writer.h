#pragma once

#include <cstdint>
#include <vector>

#include "fit/fit_part.h"
#include "fit/result_mirror.h"

namespace limber {

// The result as it was before any of its parts was fitted.
struct StartResult {
  const TriangleMesh& mesh;
  const ResultMirror* mirror;  // null where it is not its own mirror image
};

// The flips of a mesh none of whose edges has been flipped: each corner comes from itself.
Flips unflipped(const TriangleMesh& mesh);

// Writes a fitted part into the whole result, and its mirror image where that is another part: positions in
// units of the file, rounded to float32, triangles, and which corner each corner was before edges were
// flipped. `corners[3 t + c]`: the corner of the part before its flips that corner c of triangle t was.
void writePart(const FitPart& part, const std::vector<uint32_t>& corners, const StartResult& start,
               MeshAt& result);

}  // namespace limber
