#pragma once

#include <cstdint>
#include <span>

#include "query/closest_point.h"

namespace limber {

// The closest point to `point` on the triangles of a list; ties go to the first of them. An empty list means
// all triangles of the mesh, which must have one. Throws std::invalid_argument if the list contains a
// triangle that the mesh does not have. O(list), or O(n log n) for the whole mesh.
ClosestPoint closestAmong(const TriangleMesh& mesh, std::span<const uint32_t> triangles, const Vec3& point);

}  // namespace limber
