#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "base/vec3.h"
#include "elastic/parts.h"
#include "mesh/surface_point.h"

namespace limber {

// A decimated copy of a part.
struct CoarsePart {
  Part part;  // in the frame of the original
  std::vector<uint32_t>
      vertexOfInput;  // per vertex of the original: the coarse vertex that it was collapsed into
};

// Decimates a part evenly (quadrics with an edge-length term) to about `vertices` vertices. Topology is kept.
// A coarse vertex is pinned if most of the vertices collapsed into it are pinned, or if otherwise no pin
// would be left next to it. The pins leave the same number of rigid motions to the copy as to the original.
// Throws Cancelled.
CoarsePart coarsen(const Part& original, uint32_t vertices, Job& job);

// Transfers displacements of a coarse part to its original. Each vertex follows its closest point among the
// triangles around the coarse vertex that it was collapsed into and around that vertex's neighbours, so it
// never jumps to another sheet of the surface. There it moves by the displacement gradients at the corners of
// the triangle, which is exact for linear displacements and smooth across edges.
class Prolongation {
 public:
  // Keeps references to both parts.
  Prolongation(const Part& original, const CoarsePart& coarse);
  // Transfers phi(3 v + c, k) from the coarse vertices to those of the original; pinned vertices become 0.
  // `phi` may have further rows, which are not read. Throws Cancelled.
  Eigen::MatrixXd prolong(const Eigen::MatrixXd& phi, const Job& job) const;

 private:
  void prolongShape(const Eigen::Ref<const Eigen::VectorXd>& coarse, Eigen::Ref<Eigen::VectorXd> fine) const;

  const Part& original_;
  const CoarsePart& coarse_;
  std::vector<SurfacePoint> points_;  // per vertex of the original
  std::vector<uint32_t> ringStart_,
      ring_;                  // coarse vertex v has the neighbours ring_[ringStart_[v] .. [v + 1])
  std::vector<Vec3> normal_;  // per coarse vertex
};

}  // namespace limber
