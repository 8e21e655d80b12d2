#pragma once

#include "base/job.h"
#include "linear/ordering/graph_cut.h"
#include "linear/ordering/node_graph.h"

namespace limber {

// Splits a connected graph of at least two nodes into halves of comparable weight with a light separator
// between them: multilevel (Karypis and Kumar 1998); the coarsest graph is cut between rings of equal
// distance, the cut of each finer one tightened by a minimum cut. Deterministic. Throws Cancelled.
Sides separate(const NodeGraph& graph, const Job& job);

}  // namespace limber
