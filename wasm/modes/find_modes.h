#pragma once

#include "base/job.h"
#include "elastic/modes.h"

namespace limber {

// A shell part of more vertices than this is solved on a decimated copy, unless the exact solve is asked for.
inline constexpr uint32_t kExactVertices = 8000;
// One of more is not refined on the mesh itself: the factor would take over a gigabyte.
inline constexpr uint32_t kRefinedVertices = 120000;

// Modes of every part. Large shells (kExactVertices) are solved on an evenly decimated copy of at least 8,000
// vertices, and the shapes are carried back; ComponentModes::coarseVertices tells. `exact` solves all of them
// as they are. Small parts are solved side by side. Errors as computeModes.
ModeSet findModes(const TriangleMesh& mesh, const ModesOptions& options, bool exact, Job& job);

}  // namespace limber
