#pragma once

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"
#include "simplify/simplify_options.h"

namespace limber {

// Throws std::invalid_argument if a guidance field or a constraint does not fit the mesh, or an option is out
// of range.
void checkRequest(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options);

// Collapses edges, cheapest first, until no legal edge is left or `stopFaces` is reached, and records every
// collapse. Collapses that `maxDeviation` (see DeviationLimit) or `minAngle` refuses are skipped, so every
// mesh of the history respects these limits.
//
// The costs are those of the method's policy: QemCost, PaperCost or LimberCost. A collapse is legal if the
// link condition is met (components, boundary loops and genus stay the same) and no face flips; non-manifold
// edges and vertices are not changed. A refused edge is tried again when its neighbourhood changes. Ties go
// to the lower vertex indices. An edge whose cost falls when its neighbourhood changes may be collapsed late,
// see CostPolicy, but not with `paper` and a quality weight. Throws Cancelled, and std::invalid_argument as
// `checkRequest`.
History simplify(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job);

}  // namespace limber
