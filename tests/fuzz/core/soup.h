#pragma once

#include <cstdint>
#include <vector>

#include "fuzz_input.h"
#include "mesh/triangle_mesh.h"

namespace limber::fuzz {

// Triangles as a file may have them: positions[3 * v + c], indices[3 * t + corner].
struct Soup {
  std::vector<float> positions;
  std::vector<uint32_t> indices;
};

// A soup with at most about `mostTriangles` triangles: a surface (sheet, tube, torus, Moebius strip), many
// parts, fans that touch in one point, pages that share an edge or random triangles; then damaged (values
// that are no coordinates, indices out of range, doubled and turned faces) and scaled by up to 1e30.
Soup drawSoup(FuzzInput& input, uint32_t mostTriangles);

// The welded mesh of a soup without NaN, infinity and indices out of range. May be empty.
TriangleMesh drawMesh(FuzzInput& input, uint32_t mostTriangles);

}  // namespace limber::fuzz
