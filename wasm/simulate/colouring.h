#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulate/blocks.h"

namespace limber {

// Constraints in batches of four that share no vertex (graph colouring), sorted by the groups of the blocks.
struct Colouring {
  using Batch = std::array<uint32_t, 4>;  // constraint indices; kNone in an empty lane, never in the first
  std::vector<Batch> batches;
  std::vector<uint32_t> groupStart;  // batches of group g: [groupStart[g], groupStart[g + 1])

  uint32_t groupCount() const { return static_cast<uint32_t>(groupStart.size()) - 1; }
};

// One lane of a batch.
struct Lane {
  int lane;
  uint32_t constraint, group;  // the constraint is kNone if the lane is empty
};

// Calls set(batch index, Lane) for all lanes of all batches.
template <class Set>
void forEachLane(const Colouring& colouring, Set set) {
  for (uint32_t group = 0; group < colouring.groupCount(); ++group)
    for (size_t i = colouring.groupStart[group]; i < colouring.groupStart[group + 1]; ++i)
      for (int k = 0; k < 4; ++k) set(i, Lane{k, colouring.batches[i][k], group});
}

// Calls visit(batch index, lane, constraint) for the lanes of batches [begin, end) that are not empty.
template <class Visit>
void forEachConstraint(const Colouring& colouring, size_t begin, size_t end, Visit visit) {
  for (size_t i = begin; i < end; ++i)
    for (int k = 0; k < 4; ++k)
      if (colouring.batches[i][k] != kNone) visit(i, k, colouring.batches[i][k]);
}

// Colours constraints greedily: each takes the first colour of its group that no other constraint of its
// vertices has. The batches of a group come colour by colour. If the body is cut into blocks, the constraints
// that do not fill a batch of their colour come last, in batches of mixed colours. `order` 0 visits the
// constraints by index, each other number in a different shuffled order.
Colouring colour(const Stencils& stencils, const Blocks& blocks, uint32_t order);

}  // namespace limber
