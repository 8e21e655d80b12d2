#pragma once

#include "base/job.h"
#include "linear/ordering/graph_cut.h"
#include "linear/ordering/node_graph.h"

namespace limber {

// Splits a connected graph of at least two nodes into halves of comparable weight and a light separator
// between them. Multilevel (Karypis and Kumar 1998): the coarsest graph is cut between breadth-first ranks
// from several seeds, and the cut of each finer graph is tightened by a minimum cut (separator_tightening.h).
// If it finds no separator, as in a complete graph, every node is Left. Deterministic. Throws Cancelled.
Sides separate(const NodeGraph& graph, const Job& job);

}  // namespace limber
