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
  // Pinned vertices of the original and of the result. The arrays must outlive the target.
  std::span<const uint32_t> pinnedOriginal = {}, pinnedResult = {};
  // A large result is only compared at half and twice the thickness, without off-diagonal residuals. Its
  // eigenvalues are found to a tenth of the usual tolerance, because there is less to correct, and its first
  // modes come from a decimated copy with `coarseVertices` vertices.
  bool isLarge = false;
  uint32_t coarseVertices = kCoarseVertices;
};

// The target of the fit: the shell modes of the original at 0.5, 1 and 2 times the thickness. Membrane and
// bending contribute to the frequencies of a shell in proportions that depend on the thickness, so a mesh
// that is right at several thicknesses has both right. Original and result are both in the frame where the
// original's diagonal is 1. To be used within a WholePhase.
class ModalTarget {
 public:
  // Keeps a reference to `original`. All meshes that will be compared must have the triangles of `result`.
  // Throws Cancelled.
  ModalTarget(const TriangleMesh& original, const TriangleMesh& result, const ModalTargetOptions& options,
              Job& job);

  // Finds, for `compare`, the closest point of the result for each vertex of the original.
  void bind(const TriangleMesh& result);

  // Indices of the thicknesses to compare at, and whether they are best compared in parallel.
  std::vector<size_t> thicknesses() const;
  bool areParallel() const { return !options_.isLarge; }

  // The residuals of the result at one of the thicknesses, after `bind`. Starts from the modes that the last
  // call for that thickness found. Calls for different thicknesses may run in parallel. Throws Cancelled.
  Mismatch compare(const TriangleMesh& result, size_t thickness, Job& job);

  // Returns and restores the modes of the result at each thickness, as the last calls have found them.
  using Modes = std::array<ModeBasis, tuning::target::kThicknesses>;
  const Modes& lastModes() const { return last_; }
  void startFrom(const Modes& modes) { last_ = modes; }

  // Whether the original or the result has no elastic modes at some thickness, so that there is nothing to
  // fit.
  bool empty() const;

 private:
  // The number of modes that are fitted at a thickness.
  int modesAt(size_t thickness) const;
  // The requests for the shell of the result and for that of the original.
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
  Modes reference_;             // of the original, mass-normalised
  Modes last_;                  // of the result that was compared last
  std::vector<Vec3> solvedAt_;  // positions of the result for which the constructor has solved, or empty
  std::vector<ClosestPoint> binding_;  // per vertex of the original
  Eigen::VectorXd rootMass_;           // see rootMasses
};

}  // namespace limber
