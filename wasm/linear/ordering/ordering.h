#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/ordering/node_graph.h"

namespace limber {

// A fill-reducing elimination order of the nodes, by nested dissection (George 1973): the graph is cut in two
// by a small separator, both halves are ordered first, recursively, and the separator last. Separators come
// from a multilevel method that uses only the graph, no coordinates (separator.h). Remainders of at most ten
// nodes, and sets without a separator, are ordered by minimum degree (Tinney and Walker 1967). Only the
// heaviest nodes are dissected; each lighter node joins its heavy neighbours.
//
// Returns all nodes in the order of elimination. Deterministic, ties by index. For a planar graph of n nodes
// the factor has O(n log n) nonzeros (Lipton, Rose and Tarjan 1979). Throws Cancelled.
std::vector<uint32_t> eliminationOrder(const NodeGraph& graph, const Job& job);

}  // namespace limber
