#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "modes/node_graph.h"

namespace limber {

// Where a node lies once a graph is cut: no Left node has a Right neighbour.
enum Side : uint8_t { Left = 0, Right = 1, Between = 2 };
using Sides = std::vector<uint8_t>;  // a Side for each node

// What a cut costs: the separator's weight, more so the less equal the halves are.
double separatorCost(const NodeGraph& graph, const Sides& sides);

// Splits a connected graph of at least two nodes into halves of comparable weight with a light separator
// between them: multilevel (Karypis and Kumar 1998); the coarsest graph is cut between layers of distance,
// the cut of each finer one tightened by a minimum cut. Deterministic. Throws Cancelled.
Sides separate(const NodeGraph& graph, const Job& job);

}  // namespace limber
