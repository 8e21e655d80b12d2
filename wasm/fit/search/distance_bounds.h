#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// Upper bounds on the distance of the vertices of a mesh from a surface: for each vertex its distance at the
// start, or a twentieth of the mean length of the edges around it, whichever is larger. The budget of the
// search limits a mean distance, in which paws and tips hardly count because their area is small; but they
// swing, and frequencies depend on them.
class DistanceBounds {
 public:
  // Keeps a reference to the tree over the surface. `topology`: of `start`.
  DistanceBounds(const ClosestPointTree& surface, const TriangleMesh& start, const Topology& topology);

  // Returns `target` if it respects the bound of vertex v, otherwise a point between it and its closest point
  // of the surface that does. O(log n).
  Vec3 limited(uint32_t v, const Vec3& target) const;

 private:
  struct Bound {
    Vec3 start;
    double startDistance;  // at least that of `start` from the surface, and at most `most`
    double most;           // the bound
    uint32_t near;         // triangle of the surface within startDistance of `start`
  };
  const ClosestPointTree& surface_;
  std::vector<Bound> bounds_;  // per vertex
};

}  // namespace limber
