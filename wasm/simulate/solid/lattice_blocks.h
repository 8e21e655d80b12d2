#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulate/blocks.h"

namespace limber {

using LatticeCell = std::array<uint32_t, 8>;  // the nodes of its corners

// The nodes of a lattice in breadth-first order from one end of each connected part to the other,
// order[slot] = node.
std::vector<uint32_t> nodesFromEndToEnd(std::span<const LatticeCell> cells, uint32_t nodeCount);

// Cuts the nodes in the order of their indices into `count` blocks of equal size; see Blocks. The stencils
// are the cells.
Blocks latticeBlocks(std::span<const LatticeCell> cells, uint32_t nodeCount, uint32_t count);

}  // namespace limber
