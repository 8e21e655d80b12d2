#pragma once

#include <cstdint>
#include <span>

#include "base/job.h"
#include "elastic/shell_sensitivity.h"
#include "elastic/shell_vibration.h"
#include "mesh/triangle_mesh.h"

namespace limber {

struct CoarseVibrationOptions {
  int modeCount = 16;
  std::span<const uint32_t> pinned = {};  // vertices; they must leave no rigid motion free
  uint32_t vertices = 8000;               // of the copy
};

// A start for VibratingShell::follow: the vibration of an evenly decimated copy, its shapes carried back
// (without the rotations of edges). The mesh's diagonal is about 1. Throws Cancelled.
ShellVibration coarseVibration(const TriangleMesh& mesh, const ShellMaterial& material,
                               const CoarseVibrationOptions& options, Job& job);

}  // namespace limber
