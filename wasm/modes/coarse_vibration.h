#pragma once

#include <cstdint>
#include <span>

#include "base/job.h"
#include "elastic/shell_vibration.h"
#include "mesh/triangle_mesh.h"
#include "modes/vertex_limits.h"

namespace limber {

struct CoarseVibrationOptions {
  VibrationRequest request = {};  // thickness in units of the mesh
  double poisson = 0.3;
  std::span<const uint32_t> pinned = {};  // vertex ids; they must leave no rigid motion free
  uint32_t vertices = kCoarseVertices;    // of the copy
};

// A start for VibratingShell::follow: the approximate modes of an evenly decimated copy of the mesh, with
// their shapes transferred back. phi has the displacements, not the edge rotations. The diagonal of the mesh
// should be about 1. Throws as VibratingShell::solve.
ModeBasis coarseVibration(const TriangleMesh& mesh, const CoarseVibrationOptions& options, Job& job);

}  // namespace limber
