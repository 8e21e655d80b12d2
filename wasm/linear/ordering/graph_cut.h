#pragma once

#include <cstdint>
#include <vector>

#include "linear/ordering/node_graph.h"

namespace limber {

// The side of a node in a cut graph: Between is the separator. No Left node has a Right neighbour.
enum Side : uint8_t { Left = 0, Right = 1, Between = 2 };
using Sides = std::vector<uint8_t>;  // per node: its Side

// The cost of a cut with these weights of its halves and its separator: the weight of the separator,
// increased by up to one half with the imbalance of the halves, and steeply once the smaller half has less
// than two fifths of both. Infinite if a half is empty.
double cutCost(int64_t left, int64_t right, int64_t between);
// The same for a cut that is given by sides.
double separatorCost(const NodeGraph& graph, const Sides& sides);

}  // namespace limber
