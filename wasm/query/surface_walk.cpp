#include "query/surface_walk.h"

#include <cmath>

namespace limber {
namespace {

// Of the diagonal: two distances that differ by less may belong to one point on two triangles.
constexpr double kTolerance = 1e-9;

}  // namespace

SurfaceWalk::SurfaceWalk(const TriangleMesh& mesh, const Topology& topology)
    : mesh_(mesh),
      topology_(topology),
      tolerance_(kTolerance * bounds(mesh).diagonal()),
      visitedAt_(mesh.triangleCount(), 0) {}

void SurfaceWalk::visit(uint32_t triangle, const Vec3& point) {
  if (visitedAt_[triangle] == walk_) return;
  visitedAt_[triangle] = walk_;
  const ClosestPoint found = closestOnTriangle(mesh_, triangle, point);
  visited_.push_back(found);
  const bool isNearer =
      found.distance < best_.distance || (found.distance == best_.distance && triangle < best_.triangle);
  if (isNearer) best_ = found;
}

ClosestPoint SurfaceWalk::closest(const Vec3& point, std::span<const uint32_t> start,
                                  const MayCross& mayCross) {
  ++walk_;
  visited_.clear();
  best_ = {};
  best_.distance = HUGE_VAL;
  for (const uint32_t triangle : start) visit(triangle, point);
  // The walk continues across a triangle with the closest point so far; any other triangle can be dropped for
  // good.
  for (size_t i = 0; i < visited_.size(); ++i) {
    if (visited_[i].distance > best_.distance + tolerance_) continue;
    const uint32_t triangle = visited_[i].triangle;
    for (int c = 0; c < 3; ++c) {
      const uint32_t edge = topology_.edgeOpposite(Corner(triangle, c));
      for (const uint32_t next : topology_.trianglesAt(topology_.edges[edge]))
        if (next != triangle && mayCross(edge, next)) visit(next, point);
    }
  }
  return best_;
}

}  // namespace limber
