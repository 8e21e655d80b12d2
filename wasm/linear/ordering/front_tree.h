#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/ordering/node_graph.h"

namespace limber {

// A supernode of the factor: nodes that are eliminated together as one dense block.
struct FrontNodes {
  std::vector<uint32_t> pivots;    // nodes, in the order of elimination
  std::vector<uint32_t> boundary;  // later nodes that the pivots are coupled to, in the same order
  std::vector<uint32_t> children;  // fronts whose first boundary node is a pivot here, ascending
  uint64_t zeros = 0;              // explicitly stored zeros of its columns
};

// The assembly tree of an elimination order: fronts with children before parents and every subtree
// consecutive (supernodal elimination tree, Liu 1990). A front is merged into its parent if the zeros that
// this adds cost less than handling one more front (relaxed amalgamation, Duff and Reid 1983). Merging
// permutes the order within subtrees: from then on the elimination order is that of the pivots, front by
// front. Throws Cancelled.
std::vector<FrontNodes> buildFrontTree(const NodeGraph& graph, const std::vector<uint32_t>& order,
                                       const Job& job);

}  // namespace limber
