#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fit/search/deviation_guard.h"
#include "fit/search/distance_bounds.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Limits on steps in addition to the orientation and quality of faces.
struct StepLimits {
  // partners[v]: the mirror image of vertex v; both displacements are shortened together. Empty without
  // symmetry.
  std::span<const uint32_t> partners = {};
  double minAngle = 0;                  // degrees; a face with a smaller one at the start may keep it
  DeviationGuard* deviation = nullptr;  // limit on the distance of the surface from the original
  const DistanceBounds* distanceBounds = nullptr;  // limits on the distances of vertices from the original
};

// Moves vertices without flipping a face or degrading its quality much, compared with the mesh at the start.
class GuardedStep {
 public:
  // Keeps references to the objects of the limits.
  explicit GuardedStep(const TriangleMesh& start, const StepLimits& limits = {});

  // `mesh` with its vertices moved by `step`, entry 3 v + axis. No vertex moves by more than 0.2 of the
  // smallest height of the triangles around it. If a face would turn by more than 53 degrees from the start,
  // lose more than a fifth of its quality (Eq. 9) while that is below 0.45, or violate a limit, the
  // displacements of its vertices are halved, up to five times, and then set to 0.
  TriangleMesh apply(const TriangleMesh& mesh, const Eigen::VectorXd& step) const;

 private:
  bool isSound(const TriangleMesh& mesh, uint32_t t) const;
  std::vector<Vec3> limitedDisplacements(const TriangleMesh& mesh, const Eigen::VectorXd& step) const;
  std::vector<uint8_t> verticesOf(const TriangleMesh& mesh, const std::vector<uint8_t>& isMarked) const;
  std::vector<uint8_t> badVertices(const TriangleMesh& moved, const std::vector<uint8_t>& isChanged) const;

  StepLimits limits_;
  std::vector<Vec3> normal_;  // per face, at the start; 0 for a face without area, which may turn freely
  std::vector<double> quality_, angle_;  // per face: lower bounds; 0 degrees: any angle
};

}  // namespace limber
