#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "elastic/material.h"
#include "elastic/shell_vibration.h"
#include "fit/target/mismatch.h"
#include "fit/target/mode_alignment.h"
#include "fit/target/original_modes.h"
#include "fit/tuning.h"
#include "modes/vertex_limits.h"
#include "query/closest_point.h"

namespace limber {

struct ModalTargetOptions {
  ElasticMaterial material;  // a unitMaterial, whose thickness is the middle one
  int modeCount = 20;        // at the middle thickness
  // Vertices that are pinned, of the original and of the result. What they refer to must outlive the target.
  std::span<const uint32_t> pinnedOriginal = {}, pinnedResult = {};
  // A large result is compared at half and twice the thickness alone, without the residuals off the diagonal.
  // Its eigenvalues are found to a tenth of the usual tolerance, because there is less to correct, and its
  // first modes come from a decimated copy with `coarseVertices` vertices.
  bool isLarge = false;
  uint32_t coarseVertices = kCoarseVertices;
};

// The target of a fit: shell modes of the original at half, once and twice the thickness. Frequencies of
// a shell are a part for its membrane plus one for its bending, which depends on the thickness, so that a
// mesh that is right at several thicknesses has both parts right. Original and result are both in
// the frame where the original's diagonal is 1. To be used within a WholePhase.
class ModalTarget {
 public:
  // Keeps a reference to `original`. `result`: has the triangles of all meshes that will be compared. Throws
  // Cancelled.
  ModalTarget(const TriangleMesh& original, const TriangleMesh& result, const ModalTargetOptions& options,
              Job& job);

  // Finds, for `compare`, the closest point of the result for each vertex of the original.
  void bind(const TriangleMesh& result);

  // Indices of the thicknesses to compare at, and whether that is best done in parallel.
  std::vector<size_t> thicknesses() const;
  bool areParallel() const { return !options_.isLarge; }

  // The residuals of the result at one of the thicknesses, after `bind`. Starts from the modes that the last
  // call for it has found. Calls for different thicknesses may run in parallel. Throws Cancelled.
  Mismatch compare(const TriangleMesh& result, size_t thickness, Job& job);

  // The modes of the result at each thickness that the last calls have found, and a way back to such modes.
  using Modes = std::array<ModeBasis, tuning::target::kThicknesses>;
  const Modes& lastModes() const { return last_; }
  void startFrom(const Modes& modes) { last_ = modes; }

  // Whether the original or the result has no elastic modes at some thickness, so that there is nothing to
  // aim at.
  bool empty() const;

 private:
  // The number of modes that are fitted at a thickness.
  int modesAt(size_t thickness) const;
  // What is asked of the shell of the result, and of that of the original.
  VibrationRequest resultRequest(size_t thickness) const;
  VibrationRequest originalRequest(size_t thickness) const;
  double thicknessOf(size_t thickness) const;
  VibrationOptions originalOptions() const;
  void prepare(const TriangleMesh& result, Job& job);
  void prepareLarge(const TriangleMesh& result, Job& job);
  ModeBasis startCoarsely(const TriangleMesh& result, size_t thickness, Job& job) const;
  void findReference(const TriangleMesh& result, const OriginalModes& original, size_t thickness, Job& job);
  void vibrate(const TriangleMesh& result, size_t thickness, Job& job);
  Eigen::MatrixXd carriedToOriginal(const TriangleMesh& result, const ModeBasis& modes) const;

  const TriangleMesh& original_;
  ModalTargetOptions options_;
  Topology topology_;  // of the result
  VibratingShell shell_;
  Modes reference_;                    // of the original, mass-normalised
  Modes last_;                         // of the result that was compared last
  std::vector<Vec3> solvedAt_;         // positions of the result that the constructor has solved, or empty
  std::vector<ClosestPoint> binding_;  // per vertex of the original
  Eigen::VectorXd rootMass_;           // see rootMasses
};

}  // namespace limber
