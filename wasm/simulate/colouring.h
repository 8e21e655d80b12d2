#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulate/blocks.h"

namespace limber {

// Constraints in batches of four that share no vertex, and batches by the groups of a body's blocks.
struct Colouring {
  using Batch = std::array<uint32_t, 4>;  // constraints; kNone in an empty lane, never in the first
  std::vector<Batch> batches;
  std::vector<uint32_t> groupStart;  // batches of group g: [groupStart[g], groupStart[g + 1])

  uint32_t groupCount() const { return static_cast<uint32_t>(groupStart.size()) - 1; }
};

// A place in a batch.
struct Lane {
  int lane;
  uint32_t constraint, group;  // constraint kNone: it stays empty
};

// set(batch's index, Lane) for all lanes of all batches.
template <class Set>
void forEachLane(const Colouring& colouring, Set set) {
  for (uint32_t group = 0; group < colouring.groupCount(); ++group)
    for (size_t i = colouring.groupStart[group]; i < colouring.groupStart[group + 1]; ++i)
      for (int k = 0; k < 4; ++k) set(i, Lane{k, colouring.batches[i][k], group});
}

// Constraint i has the vertices vertices[i * stride .. (i + 1) * stride); kNone is none. Greedy: each
// constraint takes the first colour of its group that none of its vertices has. The batches of a group come
// colour by colour; of a body that is cut, what these leave over comes last, in batches of several colours.
// `order` 0 visits the constraints as they come, any other number in an order of its own.
Colouring colour(std::span<const uint32_t> vertices, uint32_t stride, const Blocks& blocks, uint32_t order);

}  // namespace limber
