#pragma once

#include <cmath>
#include <ranges>

#include "fuzz_targets.h"
#include "mesh/triangle_mesh.h"

namespace limber::fuzz {

template <std::ranges::range Numbers>
void requireFinite(const Numbers& numbers, const char* what) {
  for (const auto number : numbers) require(std::isfinite(number), what);
}

inline void requireMesh(const TriangleMesh& mesh) {
  for (const Vec3& p : mesh.positions)
    for (int c = 0; c < 3; ++c) require(std::isfinite(p[c]), "every position is finite");
  for (const auto& [a, b, c] : mesh.triangles) {
    require(a < mesh.vertexCount() && b < mesh.vertexCount() && c < mesh.vertexCount(),
            "every corner exists");
    require(a != b && b != c && c != a, "no triangle has a vertex twice");
  }
}

}  // namespace limber::fuzz
