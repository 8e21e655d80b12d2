#pragma once

#include <optional>

#include "base/job.h"
#include "elastic/shell_vibration.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Finds the shell modes of an original at any thickness, in a frame where its diagonal, E and rho are 1. To
// be used within a WholePhase. Calls for different thicknesses may run in parallel.
class OriginalModes {
 public:
  // Keeps references to `original` and to the arrays of the options. Throws Cancelled.
  OriginalModes(const TriangleMesh& original, const VibrationOptions& options, Job& job);

  // Whether the original is small enough (kRefinedVertices) for modes to be refined on the mesh itself.
  bool canRefine() const { return shell_.has_value(); }
  // Solves by inverse iteration from approximate modes, such as those of the result. Requires canRefine.
  ModeBasis refine(const ModeBasis& start, const VibrationRequest& request, Job& job) const;
  // Solves on a decimated copy: see findModes.
  ModeBasis findCoarsely(const VibrationRequest& request, Job& job) const;

 private:
  const TriangleMesh& original_;
  VibrationOptions options_;
  Topology topology_;
  std::optional<VibratingShell> shell_;
};

}  // namespace limber
