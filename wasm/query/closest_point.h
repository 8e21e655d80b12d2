#pragma once

#include <cstdint>
#include <vector>

#include "base/real_pair.h"
#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The point of a surface that is closest to a given one, and how far it is.
struct ClosestPoint : SurfacePoint {
  Vec3 position = {};
  double distance = 0;

  // No point, but a distance beyond which none is looked for.
  static ClosestPoint within(double distance) {
    ClosestPoint none;
    none.distance = distance;
    return none;
  }
};

// The point of triangle t closest to `point`; any triangle, needles and points included.
ClosestPoint closestOnTriangle(const TriangleMesh& mesh, uint32_t t, const Vec3& point);

// Bounding volume hierarchy over the triangles of a mesh that must outlive it. Built once, queried from any
// thread.
class ClosestPointTree {
 public:
  explicit ClosestPointTree(const TriangleMesh& mesh);
  // The closest point of the surface; ties go to the lowest triangle index. The mesh must have a triangle.
  // `near`: one that is likely to have it, which saves time.
  ClosestPoint closest(const Vec3& point, uint32_t near = kNone) const;
  // The closest point of a triangle that looks the way of `normal` (within 75 degrees), where one is hardly
  // farther off than the closest of all (1 % of the diagonal); else that. Tells sheets apart that lie close
  // together, or on one another. A normal of 0 looks every way.
  ClosestPoint closestFacing(const Vec3& point, const Vec3& normal, uint32_t near = kNone) const;

 private:
  // The triangles order_[first] to order_[first + count - 1]; where count is 0, the two branches of
  // nodes_[first].
  struct Branch {
    uint32_t first = 0, count = 0;
  };
  struct Node {
    Point<RealPair> low, high;  // of the boxes around both
    Branch branches[2];
  };
  // `box` becomes the one around these triangles.
  Branch build(uint32_t first, uint32_t count, const std::vector<Vec3>& centres, Bounds& box);
  Bounds boxAround(uint32_t first, uint32_t count) const;
  uint32_t halve(uint32_t first, uint32_t count, const std::vector<Vec3>& centres);
  // Among the triangles that count, no farther than `start`, which is found where there is none closer; it
  // may be a distance alone, without a triangle.
  template <class Counts>
  ClosestPoint search(const Vec3& point, const ClosestPoint& start, const Counts& counts) const;

  const TriangleMesh& mesh_;
  Branch root_;
  Bounds box_;
  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;
};

}  // namespace limber
