#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace limber {

// A priority queue of edges whose costs can change; the cheapest comes first, on a tie the lower edge. Costs
// are compared as float32. Keys have 64 bits: the bits of the cost, which order like the cost because it is
// not negative, above the index of the edge.
//
// Most costs change several times before their edge comes up, so a change must be cheap: keys far from the
// front are stored unordered in buckets of nearly equal costs (Dial 1969), those of the lowest bucket in a
// small heap. A new cost adds a key and leaves the old key in the queue, to be recognised by its outdated
// cost when it comes up.
class EdgeQueue {
 public:
  explicit EdgeQueue(uint32_t edgeCount) : waiting_(edgeCount, kAbsent), lastOf_(kBuckets, kNoChunk) {
    chunks_.reserve(edgeCount / 8);
  }

  bool isWaiting(uint32_t edge) const { return waiting_[edge] != kAbsent; }

  // Brings the first edge to the front; returns false if the queue is empty. Calls price(edges) for stale
  // edges that come up on the way, once for those of a bucket; it must `set` each of them.
  template <class Price>
  bool findFirst(const Price& price) {
    for (;;) {
      while (!heap_.empty()) {
        const uint64_t key = heap_.front();
        const uint32_t waiting = waiting_[edgeOf(key)];
        if (waiting == costOf(key)) return true;
        popKey();
        if (waiting != (costOf(key) | kStale)) continue;
        stale_.assign(1, edgeOf(key));
        price(stale_);
      }
      if (!openNextBucket()) return false;
      if (!stale_.empty()) price(stale_);
    }
  }
  // The following two functions may be called after findFirst has returned true.
  bool wouldBeFirst(uint32_t edge, double cost) const { return keyOf(edge, cost) < heap_.front(); }
  uint32_t pop() {
    const uint32_t edge = edgeOf(heap_.front());
    waiting_[edge] = kAbsent;
    popKey();
    return edge;
  }

  // Adds an edge or changes its cost. `cost` must not be negative nor NaN.
  void set(uint32_t edge, double cost) {
    const uint64_t key = keyOf(edge, cost);
    const uint32_t bits = costOf(key);
    if (waiting_[edge] == bits) return;
    waiting_[edge] = bits;
    if (bits >> kShift <= current_)
      pushKey(key);
    else
      store(bits >> kShift, key);
  }

  // The cost of a queued edge, or its estimate.
  float cost(uint32_t edge) const { return std::bit_cast<float>(waiting_[edge] & ~kStale); }
  // Adds an edge or changes its cost, with an estimate: the edge is stale and will be priced before it can
  // come first.
  void markStale(uint32_t edge, double estimate) {
    waiting_[edge] &= ~kStale;
    set(edge, estimate);
    waiting_[edge] |= kStale;
  }
  // Removes an edge if it is queued.
  void remove(uint32_t edge) { waiting_[edge] = kAbsent; }

 private:
  // 16 buckets for each power of two.
  static constexpr uint32_t kShift = 19, kBuckets = 1u << (32 - kShift);
  static constexpr uint32_t kAbsent = 0xffffffffu, kNoChunk = 0xffffffffu;
  static constexpr uint32_t kStale = 0x80000000u;  // the sign bit, which no cost has
  // A part of a bucket: two cache lines.
  struct Chunk {
    static constexpr uint32_t kCapacity = 15;
    uint32_t previous, count;
    uint64_t keys[kCapacity];
  };

  static uint64_t keyOf(uint32_t edge, double cost) {
    return uint64_t{std::bit_cast<uint32_t>(static_cast<float>(cost) + 0.0f)} << 32 | edge;  // -0 becomes 0
  }
  static uint32_t edgeOf(uint64_t key) { return static_cast<uint32_t>(key); }
  static uint32_t costOf(uint64_t key) { return static_cast<uint32_t>(key >> 32); }

  void store(uint32_t bucket, uint64_t key) {
    uint32_t last = lastOf_[bucket];
    if (last == kNoChunk || chunks_[last].count == Chunk::kCapacity) last = lastOf_[bucket] = newChunk(last);
    Chunk& chunk = chunks_[last];
    chunk.keys[chunk.count++] = key;
  }
  uint32_t newChunk(uint32_t previous) {
    uint32_t index = spare_;
    if (index == kNoChunk) {
      index = static_cast<uint32_t>(chunks_.size());
      chunks_.emplace_back();
    } else {
      spare_ = chunks_[index].previous;
    }
    chunks_[index].previous = previous;
    chunks_[index].count = 0;
    return index;
  }

  // Moves the keys of the next bucket to the heap, those of stale edges to `stale_`.
  bool openNextBucket() {
    uint32_t next = current_ + 1;
    while (next < kBuckets && lastOf_[next] == kNoChunk) ++next;
    if (next >= kBuckets) return false;
    current_ = next;
    size_t fresh = 0, stale = 0;
    for (uint32_t index = lastOf_[next]; index != kNoChunk;) {
      Chunk& chunk = chunks_[index];
      heap_.resize(fresh + Chunk::kCapacity);
      stale_.resize(stale + Chunk::kCapacity);
      for (uint32_t i = 0; i < chunk.count; ++i) {
        // Branch-free, because branches would be unpredictable.
        const uint64_t key = heap_[fresh] = chunk.keys[i];
        stale_[stale] = edgeOf(key);
        const uint32_t waiting = waiting_[edgeOf(key)];
        fresh += waiting == costOf(key);
        stale += waiting == (costOf(key) | kStale);
      }
      const uint32_t previous = chunk.previous;
      chunk.previous = spare_;
      spare_ = index;
      index = previous;
    }
    lastOf_[next] = kNoChunk;
    heap_.resize(fresh);
    stale_.resize(stale);
    for (auto slot = static_cast<uint32_t>(heap_.size()); slot-- > 0;) moveDown(slot, heap_[slot]);
    return true;
  }

  // A four-way heap.
  void pushKey(uint64_t key) {
    auto slot = static_cast<uint32_t>(heap_.size());
    heap_.push_back(key);
    while (slot > 0) {
      const uint32_t parent = (slot - 1) / 4;
      if (heap_[parent] <= key) break;
      heap_[slot] = heap_[parent];
      slot = parent;
    }
    heap_[slot] = key;
  }
  void popKey() {
    const uint64_t last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) moveDown(0, last);
  }
  // Moves `key` down from the free `slot` to its position in the heap.
  void moveDown(uint32_t slot, uint64_t key) {
    const auto size = static_cast<uint32_t>(heap_.size());
    for (uint32_t first; (first = 4 * slot + 1) < size;) {
      const uint32_t least = first + 3 < size ? leastOfFour(first) : leastOf(first, size);
      if (key <= heap_[least]) break;
      heap_[slot] = heap_[least];
      slot = least;
    }
    heap_[slot] = key;
  }
  // Branch-free, because branches would be unpredictable.
  uint32_t leastOfFour(uint32_t first) const {
    const uint64_t* keys = heap_.data() + first;
    const uint32_t left = keys[1] < keys[0], right = 2 + (keys[3] < keys[2]);
    return first + (keys[right] < keys[left] ? right : left);
  }
  uint32_t leastOf(uint32_t first, uint32_t end) const {
    uint32_t least = first;
    for (uint32_t child = first + 1; child < end; ++child)
      if (heap_[child] < heap_[least]) least = child;
    return least;
  }

  // Per edge: the bits of the cost at which it is queued, with kStale if that is an estimate; or kAbsent.
  std::vector<uint32_t> waiting_;
  std::vector<uint32_t> stale_;  // scratch
  std::vector<uint64_t> heap_;   // the keys of all buckets up to `current_`
  uint32_t current_ = 0;
  std::vector<uint32_t> lastOf_;  // per bucket: its last chunk, or kNoChunk
  std::vector<Chunk> chunks_;
  uint32_t spare_ = kNoChunk;  // the first free chunk; each points to the next by `previous`
};

}  // namespace limber
