#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "simplify/cost/cost_base.h"
#include "simplify/history.h"
#include "simplify/legality.h"
#include "simplify/simplify.h"

namespace limber {

// Why a vertex is still part of a simplified mesh: the collapse of one of its edges that would come first.
struct WhyKept {
  uint32_t neighbour = kNone;  // the other end, in the same numbering; kNone for a vertex without edges
  CostTerms terms;             // of that collapse; 0 if the vertex is locked
  Verdict verdict = Verdict::Locked;  // of that collapse; the cheapest legal one has priority over all others
};

// A history together with its inputs.
struct Reduction {
  const TriangleMesh& mesh;
  Guidance guidance;
  const SimplifyOptions& options;
  const History& history;
};

// The reason for every vertex of meshAt(mesh, history, faces), in its order. maxDeviation is not checked.
// Replays the collapses up to there without pricing them, which takes about a third of the time of
// `simplify`. Throws Cancelled, and std::invalid_argument if the history does not belong to the inputs.
std::vector<WhyKept> whyKept(const Reduction& reduction, uint32_t faces, Job& job);

}  // namespace limber
