#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "simplify/cost.h"
#include "simplify/history.h"
#include "simplify/legality.h"
#include "simplify/simplify.h"

namespace limber {

// What speaks for a vertex of a simplified mesh: the collapse among its edges that would come first.
struct WhyKept {
  uint32_t neighbour =
      kNone;        // the vertex at the other end, in the same numbering; kNone where there is no edge
  CostTerms terms;  // of that collapse; 0 where the vertex is Locked
  Verdict verdict = Verdict::Locked;  // whether it is legal; the cheapest legal one comes before all others
};

// For every vertex of meshAt(mesh, history, faces), in its order. `guidance` and `options` must be those of
// the history; maxDeviation is not asked. Repeats the collapses up to there without pricing them: about a
// third of the time of `simplify`. Throws Cancelled, and std::invalid_argument where the history does not
// belong to them.
std::vector<WhyKept> whyKept(const TriangleMesh& mesh, const Guidance& guidance,
                             const SimplifyOptions& options, const History& history, uint32_t faces,
                             Job& job);

}  // namespace limber
