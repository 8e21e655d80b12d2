#pragma once

#include <cstddef>
#include <vector>

#include "elastic/parts.h"

namespace limber {

// Per part the first one that it equals up to a translation, itself if there is none: the same model,
// triangles and pins, and positions that differ by no more than rounding to float32 in the body does. Equal
// parts have equal modes, so that one solve is enough. O(vertices + parts log parts), unless very many parts
// with the same triangles have the same diagonal and differ.
std::vector<size_t> firstEqualParts(const TriangleMesh& body, const std::vector<Part>& parts);

}  // namespace limber
