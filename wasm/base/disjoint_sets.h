#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace limber {

// Disjoint sets of the numbers 0 to count - 1, each initially a set of its own (union-find with path
// halving). The root of a set is its smallest number, so the result does not depend on the order of the
// unions. Every operation is amortised O(log count).
class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  uint32_t rootOf(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(uint32_t i, uint32_t j) {
    const uint32_t a = rootOf(i), b = rootOf(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  // The root of each number.
  std::vector<uint32_t> roots() {
    std::vector<uint32_t> all(parent_.size());
    for (uint32_t i = 0; i < all.size(); ++i) all[i] = rootOf(i);
    return all;
  }

 private:
  std::vector<uint32_t> parent_;
};

}  // namespace limber
