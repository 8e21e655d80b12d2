#pragma once

#include <cstdint>

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"
#include "query/bounding_tree.h"

namespace limber {

// The point of a surface that is closest to a given point, and the distance between both.
struct ClosestPoint : SurfacePoint {
  Vec3 position = {};
  double distance = 0;

  // The start of a search within a distance: no point yet.
  static ClosestPoint within(double distance) {
    ClosestPoint none;
    none.distance = distance;
    return none;
  }
};

// The point of triangle t closest to `point`. Needles and triangles degenerated to a point are allowed. Its
// barycentric coordinates are at least 0, and their sum is 1 up to 1e-8.
ClosestPoint closestOnTriangle(const TriangleMesh& mesh, uint32_t t, const Vec3& point);

// The position of the point of triangle abc closest to p. Faster than `closestOnTriangle`, because it
// computes no barycentric coordinates; the two may differ by rounding.
Vec3 closestPosition(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

// Bounding boxes over the triangles of a mesh.
BoundingTree treeOver(const TriangleMesh& mesh);

// Finds closest points of a mesh that must outlive it. Built in O(n log n), queried from any thread.
class ClosestPointTree {
 public:
  explicit ClosestPointTree(const TriangleMesh& mesh);
  // The closest point of the surface; ties go to the lowest triangle index. The mesh must have a triangle.
  // `near` is a triangle that is likely to contain the point; a good guess saves time.
  ClosestPoint closest(const Vec3& point, uint32_t near = kNone) const;
  // The closest point if the surface is farther away than `enough`; otherwise any point within `enough`,
  // which takes a fraction of the time. `near` as above.
  ClosestPoint nearEnough(const Vec3& point, double enough, uint32_t near = kNone) const;
  // The nearest corner of a triangle if all corners are farther away than `enough`; otherwise any corner
  // within `enough`. `near` as above.
  ClosestPoint nearestCorner(const Vec3& point, double enough, uint32_t near = kNone) const;
  // The closest point on a triangle whose normal is within 75 degrees of `normal`, if that point is at most 1
  // % of the diagonal of the triangles farther away than the closest point of the whole surface; else the
  // latter. This distinguishes sheets that lie close together or on top of each other. A zero normal admits
  // every triangle.
  ClosestPoint closestFacing(const Vec3& point, const Vec3& normal, uint32_t near = kNone) const;

 private:
  // The closest point among the triangles that `counts` admits, or `start` if none is closer. `start` may be
  // a distance without a triangle. The search ends at the first point within `enough`.
  template <class Counts>
  ClosestPoint search(const Vec3& point, const ClosestPoint& start, const Counts& counts,
                      double enough = -1) const;

  const TriangleMesh& mesh_;
  BoundingTree tree_;
};

}  // namespace limber
