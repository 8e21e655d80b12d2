#pragma once

#include "base/job.h"
#include "elastic/modes.h"
#include "modes/vertex_limits.h"

namespace limber {

// The modes of every part, as computeModes finds them, but faster for large shells and for many parts.
//
// A shell part with more than kExactVertices vertices is solved on an evenly decimated copy, whose shapes are
// transferred back. With up to kRefinedVertices vertices the copy has kCoarseVertices, and the modes are
// refined on the part itself to 1e-4 in frequency; larger parts get a copy of kUnrefinedCopyVertices and are
// not refined. If modes only guide (ModesOptions::guidedParts), shells of more than kGuidingCopyVertices get
// a copy of that size, without refinement. ComponentModes::coarseVertices has the size of the copy. `exact`
// solves all parts without copies. Small parts are solved in parallel. Throws as computeModes.
ModeSet findModes(const TriangleMesh& mesh, const ModesOptions& options, bool exact, Job& job);

}  // namespace limber
