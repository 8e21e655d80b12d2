#pragma once

#include "linear/ordering/graph_cut.h"

namespace limber {

// Replaces the separator of a valid cut by the lightest one within five rings around it. That is a minimum
// vertex cut: a maximum flow through the band in which each node lets its weight pass. Halves of at
// least two fifths of the weight stay so. Returns whether the cut became cheaper.
bool tightenSeparator(const NodeGraph& graph, Sides& sides);

}  // namespace limber
