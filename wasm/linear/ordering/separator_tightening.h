#pragma once

#include "linear/ordering/graph_cut.h"

namespace limber {

// Replaces the separator of a valid cut by the lightest one within a band around it: a minimum cut, each node
// of the band letting through its weight. Both halves keep two fifths of the weight. Returns whether the cut
// became cheaper.
bool tightenSeparator(const NodeGraph& graph, Sides& sides);

}  // namespace limber
