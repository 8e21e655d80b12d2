#pragma once

#include <cstdint>
#include <vector>

#include "fit/fit_part.h"
#include "fit/result_mirror.h"

namespace limber {

// The result before any of its parts was fitted.
struct StartResult {
  const TriangleMesh& mesh;
  const ResultMirror* mirror;  // null if it is not its own mirror image
};

// The identity: the flips of a mesh without flipped edges, where each corner comes from itself.
Flips unflipped(const TriangleMesh& mesh);

// Writes a fitted part into the whole result, and also its mirror image if that is another part: positions in
// units of the file, rounded to float32, triangles, and for each corner the corner that it was before edges
// were flipped. `corners[3 t + c]`: the corner of the part before its flips that corner c of triangle t was.
void writePart(const FitPart& part, const std::vector<uint32_t>& corners, const StartResult& start,
               MeshAt& result);

}  // namespace limber
