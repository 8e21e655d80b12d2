#pragma once

#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// How far the vertices of a mesh may leave a surface: as far as they are at the start, or a twentieth of
// the edges around them. A mean distance hardly tells what happens to paws and tips, for their area is small;
// but they swing, so that frequencies hang on them.
class Reach {
 public:
  // Keeps a reference to `surface`.
  Reach(const TriangleMesh& surface, const TriangleMesh& start, const Topology& topology);

  // Where vertex v comes to when it goes to `place`: there, or the point between it and the surface that is
  // within reach. O(log n).
  Vec3 limited(uint32_t v, const Vec3& place) const;

 private:
  struct Vertex {
    Vec3 start;
    double distance, most;  // from the surface: at the start, and ever
  };
  ClosestPointTree tree_;
  std::vector<Vertex> vertices_;
};

}  // namespace limber
