#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/ordering/node_graph.h"

namespace limber {

// Nodes that are eliminated together as one dense block: a supernode of the factor.
struct FrontNodes {
  std::vector<uint32_t> pivots;    // nodes, in the order of elimination
  std::vector<uint32_t> boundary;  // nodes eliminated later that the pivots are coupled to, likewise
  std::vector<uint32_t> children;  // fronts whose boundaries reach first into this one, ascending
  uint64_t zeros = 0;              // entries of its columns that are stored though they are 0
};

// Which fronts an order of elimination gives (children before parents, every subtree consecutive). Fronts are
// merged with their parent where the zeros that this stores as entries cost less than handling one front
// more. The pivots, front by front, are the order of elimination from then on.
std::vector<FrontNodes> buildFrontTree(const NodeGraph& graph, const std::vector<uint32_t>& order,
                                       const Job& job);

}  // namespace limber
