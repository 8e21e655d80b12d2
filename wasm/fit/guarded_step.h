#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "fit/deviation_guard.h"
#include "fit/reach.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// What else steps must keep.
struct StepLimits {
  // Per vertex the one that is its image and goes as far; may be empty.
  std::span<const uint32_t> partners = {};
  double minAngle = 0;                  // degrees; a face that has a smaller one may keep it
  DeviationGuard* deviation = nullptr;  // nearness to the original
  const Reach* reach = nullptr;         // the same of vertices alone
};

// Moves vertices without turning a face over or ruining its shape, judged against the mesh as it was at the
// start.
class GuardedStep {
 public:
  // Keeps references to what the limits refer to.
  explicit GuardedStep(const TriangleMesh& start, const StepLimits& limits = {});

  // mesh.positions + step (3 numbers a vertex). No vertex moves farther than 0.2 of its shortest edge; the
  // vertices of a face that would turn by more than about 50 degrees against the start, or lose much of its
  // quality (Eq. 9) or break a limit, take half of the step, again and again, and none in the end.
  TriangleMesh apply(const TriangleMesh& mesh, const Eigen::VectorXd& step) const;

 private:
  bool isSound(const TriangleMesh& mesh, uint32_t t) const;
  std::vector<uint8_t> verticesOf(const TriangleMesh& mesh, const std::vector<uint8_t>& isIn) const;
  std::vector<uint8_t> badVertices(const TriangleMesh& moved) const;

  StepLimits limits_;
  std::vector<Vec3> normal_;  // of the faces at the start; 0 for one without area, which may do what it likes
  std::vector<double> quality_, angle_;  // that each must keep
};

}  // namespace limber
