#pragma once

#include <cstdint>
#include <vector>

#include "modes/stiffness_model.h"

namespace limber {

// A set of nodes that are eliminated together, in the tree of a nested dissection: a separator, or a leaf's
// nodes.
struct DissectionPart {
  std::vector<uint32_t> nodes;     // ascending
  std::vector<uint32_t> children;  // parts that this one separates
  uint32_t depth = 0;              // of the root: 0
};

// Parts in an order of elimination: children stand before their parents, the root is last. No two parts of
// which neither is the other's ancestor are coupled.
struct Dissection {
  std::vector<DissectionPart> parts;
};

// Geometric nested dissection (George 1973): the nodes are halved at the median along the longest side of
// their box, and the smaller of the two rims along the cut becomes the separator. Deterministic.
Dissection dissect(const StiffnessModel& model);

}  // namespace limber
