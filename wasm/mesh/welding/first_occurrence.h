#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace limber {

// Finds the first item with an equal key, for keys of three words and up to `count` items. An open-addressing
// hash table, whose answers do not depend on the hash.
class FirstOccurrence {
 public:
  using Key = std::array<uint32_t, 3>;

  explicit FirstOccurrence(size_t count) : slots_(std::bit_ceil(2 * count + 2), kEmpty), keys_(count) {}

  // Adds `item` (less than `count`, each once) with its key and returns the first item that was added with an
  // equal key, which may be `item` itself. Expected O(1).
  uint32_t insert(const Key& key, uint32_t item) {
    keys_[item] = key;
    for (size_t slot = hash(key);; ++slot) {
      uint32_t& found = slots_[slot & (slots_.size() - 1)];
      if (found == kEmpty) found = item;
      if (keys_[found] == key) return found;
    }
  }

 private:
  static constexpr uint32_t kEmpty = 0xffffffffu;

  static size_t hash(const Key& key) {
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (uint32_t word : key) {
      h = (h ^ word) * 0xff51afd7ed558ccdu;
      h ^= h >> 32;
    }
    return static_cast<size_t>(h);
  }

  std::vector<uint32_t> slots_;
  std::vector<Key> keys_;
};

}  // namespace limber
