#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace limber {

// Finds equal keys of three words among up to `count` items: an open-addressing hash table whose answers do
// not depend on the hash.
class FirstOccurrence {
 public:
  using Key = std::array<uint32_t, 3>;

  explicit FirstOccurrence(size_t count) : slots_(std::bit_ceil(2 * count + 2), kEmpty), keys_(count) {}

  // Files `item` (less than `count`, each once) under `key` and returns the first item that was filed under
  // an equal key; `item` itself if it is the first.
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
