#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/ordering/node_graph.h"

namespace limber {

// The order in which the nodes are eliminated so that the factor stays sparse: nested dissection (George
// 1973) with separators found from coordinates and graph distances, small remainders by minimum degree.
// Deterministic.
std::vector<uint32_t> eliminationOrder(const NodeGraph& graph, const Job& job);

}  // namespace limber
