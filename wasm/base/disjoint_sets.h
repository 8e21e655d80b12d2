#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace limber {

// Sets of the numbers below a count, at first each alone. A set is named by its smallest number, whatever the
// order in which it came together; paths are halved on the way.
class DisjointSets {
 public:
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
