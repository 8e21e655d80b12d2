#include "query/closest_among.h"

#include <cmath>
#include <stdexcept>

namespace limber {

ClosestPoint closestAmong(const TriangleMesh& mesh, std::span<const uint32_t> triangles, const Vec3& point) {
  if (mesh.triangles.empty()) throw std::invalid_argument("A mesh without triangles has no closest point.");
  if (triangles.empty()) return ClosestPointTree(mesh).closest(point);
  ClosestPoint best = ClosestPoint::within(HUGE_VAL);
  for (const uint32_t t : triangles) {
    if (t >= mesh.triangleCount()) throw std::invalid_argument("The mesh has no such triangle.");
    const ClosestPoint found = closestOnTriangle(mesh, t, point);
    if (found.distance < best.distance) best = found;
  }
  return best;
}

}  // namespace limber
