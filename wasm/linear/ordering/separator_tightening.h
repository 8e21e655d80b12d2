#pragma once

#include "linear/ordering/graph_cut.h"

namespace limber {

// Replaces the separator of a valid cut by the lightest one within five rings around it. That is a minimum
// vertex cut, found by a maximum flow through the band in which the capacity of each node is its weight.
// Halves of at least two fifths of the weight remain so. Returns whether the cut became cheaper.
bool tightenSeparator(const NodeGraph& graph, Sides& sides);

}  // namespace limber
