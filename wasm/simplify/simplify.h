#pragma once

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"
#include "simplify/options.h"

namespace limber {

// Throws std::invalid_argument where a guidance field or a constraint does not fit the mesh, or an option is
// out of its range.
void checkRequest(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options);

// Collapses edges, cheapest first, until no legal edge is left or `stopFaces` is reached, and records every
// collapse. What `maxDeviation` (see DeviationLimit) or `minAngle` refuses is passed over, so every mesh of
// the history keeps these limits.
//
// The costs are those of the method's policy: QemCost, PaperCost or LimberCost. A collapse is legal where the
// link condition is met (components, boundary loops and genus stay the same) and no face flips;
// non-manifold edges and vertices stay untouched. A refused edge is tried again when its neighbourhood
// changes. Ties go to the lower vertex indices. An edge whose cost falls when its neighbourhood changes may
// come late, see CostPolicy; `paper` with a quality weight never lets it. Throws Cancelled, and
// std::invalid_argument as `checkRequest`.
History simplify(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job);

}  // namespace limber
