#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Moves vertices without turning a face over or ruining its shape, judged against the mesh as it was at the
// start.
class GuardedStep {
 public:
  // Keeps a reference to `topology`, which must be that of the meshes that are moved, and to `partners`: per
  // vertex the one that is its image and goes as far; may be empty.
  GuardedStep(const TriangleMesh& start, const Topology& topology, std::span<const uint32_t> partners = {});

  // mesh.positions + step (3 numbers a vertex). No vertex moves farther than 0.2 of its shortest edge; the
  // vertices of a face that would turn by more than about 50 degrees against the start, or lose much of its
  // quality (Eq. 9), take half of the step, again and again, and none in the end.
  TriangleMesh apply(const TriangleMesh& mesh, const Eigen::VectorXd& step) const;

 private:
  bool isSound(const TriangleMesh& mesh, uint32_t t) const;

  const Topology& topology_;
  std::span<const uint32_t> partners_;
  std::vector<Vec3> normal_;  // of the faces at the start; 0 for one without area, which may do what it likes
  std::vector<double> quality_;  // that each must keep
};

}  // namespace limber
