#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace limber {

// A priority queue of edges, the cheapest first and the lower edge on a tie, in which an edge's cost can
// change. Costs are compared as float32. A four-way heap of 64-bit keys: the cost's bits, which order like
// the cost because it is not negative, above the edge's index.
class EdgeHeap {
 public:
  explicit EdgeHeap(uint32_t edgeCount) : place_(edgeCount, kAbsent) {}

  bool empty() const { return keys_.empty(); }

  // Adds an edge or changes its cost. `cost` must not be negative nor NaN.
  void set(uint32_t edge, double cost) {
    const uint64_t key = keyOf(edge, cost);
    uint32_t place = place_[edge];
    if (place == kAbsent) {
      place = static_cast<uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    moveUp(place, key);
    if (place_[edge] == place) moveDown(place, key);
  }

  // Adds an edge that is not there yet; the heap has no order until `build`.
  void append(uint32_t edge, double cost) { keys_.push_back(keyOf(edge, cost)); }
  void build() {
    for (uint32_t place = 0; place < keys_.size(); ++place) store(place, keys_[place]);
    for (uint32_t place = static_cast<uint32_t>(keys_.size()); place-- > 0;) moveDown(place, keys_[place]);
  }

  // Whether an edge that is not there would be popped before all others at this cost.
  bool wouldBeFirst(uint32_t edge, double cost) const {
    return keys_.empty() || keyOf(edge, cost) < keys_.front();
  }

  uint32_t pop() {
    const uint32_t edge = edgeOf(keys_.front());
    place_[edge] = kAbsent;
    const uint64_t last = keys_.back();
    keys_.pop_back();
    if (!keys_.empty()) moveDown(0, last);
    return edge;
  }

  // Takes an edge out, if it is there.
  void remove(uint32_t edge) {
    const uint32_t place = place_[edge];
    if (place == kAbsent) return;
    place_[edge] = kAbsent;
    const uint64_t last = keys_.back();
    keys_.pop_back();
    if (place == keys_.size()) return;
    moveUp(place, last);
    if (place_[edgeOf(last)] == place) moveDown(place, last);
  }

 private:
  static constexpr uint32_t kAbsent = 0xffffffffu;

  static uint64_t keyOf(uint32_t edge, double cost) {
    return uint64_t{std::bit_cast<uint32_t>(static_cast<float>(cost))} << 32 | edge;
  }
  static uint32_t edgeOf(uint64_t key) { return static_cast<uint32_t>(key); }

  void store(uint32_t place, uint64_t key) {
    keys_[place] = key;
    place_[edgeOf(key)] = place;
  }

  // Both put `key` where it belongs, starting from the free `place`.
  void moveUp(uint32_t place, uint64_t key) {
    while (place > 0) {
      const uint32_t parent = (place - 1) / 4;
      if (keys_[parent] <= key) break;
      store(place, keys_[parent]);
      place = parent;
    }
    store(place, key);
  }
  void moveDown(uint32_t place, uint64_t key) {
    const auto size = static_cast<uint32_t>(keys_.size());
    for (uint32_t first; (first = 4 * place + 1) < size;) {
      const uint32_t least = first + 3 < size ? leastOfFour(first) : leastOf(first, size);
      if (key <= keys_[least]) break;
      store(place, keys_[least]);
      place = least;
    }
    store(place, key);
  }

  // Without branches, which nobody could predict.
  uint32_t leastOfFour(uint32_t first) const {
    const uint64_t* keys = keys_.data() + first;
    const uint32_t left = keys[1] < keys[0], right = 2 + (keys[3] < keys[2]);
    return first + (keys[right] < keys[left] ? right : left);
  }
  uint32_t leastOf(uint32_t first, uint32_t end) const {
    uint32_t least = first;
    for (uint32_t child = first + 1; child < end; ++child)
      if (keys_[child] < keys_[least]) least = child;
    return least;
  }

  std::vector<uint64_t> keys_;
  std::vector<uint32_t> place_;  // per edge: where its key is, or kAbsent
};

}  // namespace limber
