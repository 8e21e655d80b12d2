#pragma once

#include <cstdint>
#include <vector>

#include "linear/ordering/node_graph.h"

namespace limber {

// Where a node lies once a graph is cut: no Left node has a Right neighbour.
enum Side : uint8_t { Left = 0, Right = 1, Between = 2 };
using Sides = std::vector<uint8_t>;  // a Side for each node

// What a cut costs whose halves and separator have these weights: the separator's weight, more so the less
// equal the halves are; infinite where a half is empty.
double cutCost(int64_t left, int64_t right, int64_t between);
// The same of a cut that is given by sides.
double separatorCost(const NodeGraph& graph, const Sides& sides);

}  // namespace limber
