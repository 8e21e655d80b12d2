#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "fit/fit_part.h"
#include "fit/search/guarded_step.h"
#include "fit/surface/original_surface.h"
#include "fit/surface/sheet_sizes.h"
#include "fit/surface/surface_fit.h"

namespace limber {

// Moves the vertices of a part, round by round, so that its surface is nearest to that of the original, while
// the sizes of its sheets stay the original's. With E(dx) the squared distance (SurfaceFit), a round takes
//   dx = A^-1 (g + C lambda),    C^T dx = sizes of the original - sizes of the result,
// the least distance under linear conditions (Nocedal and Wright 2006, section 16.1), where the columns of C
// are the derivatives of area and outline. The multipliers lambda are reduced if meeting the conditions would
// cost more distance than the round gains, so that no round makes the fit worse.
//
// A part without a border has no outline, and its area has a tolerance: it may differ from the original's by
// as much as at the start. A tighter condition would cost distance, since a polyhedron near a curved surface
// has a different area.
class ShapeRounds {
 public:
  // Keeps references to all arguments but `limits`. The rounds start from part.result.
  ShapeRounds(FitPart& part, const OriginalSurface& original, const StepLimits& limits, Job& job);

  // Does one round, which changes the positions of part.result; its triangles may have changed since the last
  // round. Throws Cancelled.
  void move();

  // The root mean square distance of the original's surface from part.result at the start.
  double startDistance() const { return startDistance_; }

 private:
  // A separate function, so that the matrix of a round is freed before the step is taken: both take much
  // memory.
  Eigen::VectorXd nextStep();
  // `sizes` and `sizeGradients`: those of the current mesh.
  Eigen::VectorXd stepOf(const SurfaceFit& fit, const Eigen::Vector2d& sizes,
                         const Eigen::MatrixX2d& sizeGradients) const;
  bool isClosed() const { return wanted_[1] == 0; }
  Eigen::Vector2d wantedChange(const Eigen::Vector2d& planned) const;

  FitPart& part_;
  const FitSamples& samples_;
  StepLimits limits_;
  Job& job_;
  Eigen::Vector2d wanted_;  // area and length of the outline of the original
  double areaRange_ = 0;    // how far the area may be from the wanted area
  double startDistance_ = 0;
  std::vector<uint32_t> closestTriangles_;  // of the last round, see SurfaceFit
};

}  // namespace limber
