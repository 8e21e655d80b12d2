#pragma once

#include <cstddef>
#include <vector>

#include "elastic/parts.h"

namespace limber {

// For each part the first one that it equals up to a translation, itself if there is none. Equal parts have
// the same model, triangles and pins, and positions that differ by no more than rounding to float32 in the
// body. They have equal modes, so one solve is enough. O(vertices + parts log parts), unless very many
// different parts have the same triangles and the same diagonal.
std::vector<size_t> firstEqualParts(const TriangleMesh& body, const std::vector<Part>& parts);

}  // namespace limber
