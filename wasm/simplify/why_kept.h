#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "simplify/cost/cost_base.h"
#include "simplify/history.h"
#include "simplify/legality.h"
#include "simplify/simplify.h"

namespace limber {

// Why a vertex is part of a simplified mesh: the collapse among those of its edges that would come first.
struct WhyKept {
  uint32_t neighbour = kNone;  // the other end, in the same numbering; kNone for a vertex without edges
  CostTerms terms;             // of that collapse; 0 where the vertex is locked
  Verdict verdict = Verdict::Locked;  // of that collapse; the cheapest legal one comes before all others
};

// A history together with what it was made from.
struct Reduction {
  const TriangleMesh& mesh;
  Guidance guidance;
  const SimplifyOptions& options;
  const History& history;
};

// For every vertex of meshAt(mesh, history, faces), in its order. maxDeviation is not asked. Repeats the
// collapses up to there without pricing them, which takes about a third of the time of `simplify`. Throws
// Cancelled, and std::invalid_argument where the history does not belong to the rest.
std::vector<WhyKept> whyKept(const Reduction& reduction, uint32_t faces, Job& job);

}  // namespace limber
