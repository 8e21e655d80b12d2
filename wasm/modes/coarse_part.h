#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/parts.h"

namespace limber {

// A part with fewer triangles in its place, and where its vertices have gone.
struct CoarsePart {
  Part part;                            // in the frame of the original
  std::vector<uint32_t> vertexOfInput;  // per vertex of the original: the one that it has become
};

// Decimates a part evenly, down to about `vertices` vertices. Topology is kept; a vertex is pinned where most
// of what it stands for was, or else nothing would hold that place.
CoarsePart coarsen(const Part& original, uint32_t vertices, Job& job);

// Carries displacements of a coarse part to its original: each vertex follows the nearest point among the
// triangles around the vertex that it has become (so it never jumps to another sheet), there by the gradients
// of the coarse displacement at the triangle's corners, which is exact for linear displacements and smooth
// across edges.
class Prolongation {
 public:
  // Keeps a reference to `coarse`.
  Prolongation(const TriangleMesh& original, const CoarsePart& coarse);
  std::vector<Vec3> prolong(const std::vector<Vec3>& displacement) const;

 private:
  struct Place {
    uint32_t triangle = 0;
    double weight[3] = {1, 0, 0};
  };

  const TriangleMesh& original_;
  const CoarsePart& coarse_;
  std::vector<Place> places_;        // per vertex of the original
  std::vector<uint32_t> ringStart_;  // neighbours of coarse vertices
  std::vector<uint32_t> ring_;
  std::vector<Vec3> normal_;  // of coarse vertices
};

}  // namespace limber
