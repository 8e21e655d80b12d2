#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace limber {

// The vertices of a mesh that are fixed in place, in its modes and in its simulation: unique ascending ids.
// Converts to std::span<const uint32_t>.
class PinnedVertices {
 public:
  PinnedVertices() = default;
  // Sorts `ids` and drops duplicates. O(n log n).
  explicit PinnedVertices(std::vector<uint32_t> ids) : ids_(std::move(ids)) {
    std::ranges::sort(ids_);
    const auto repeated = std::ranges::unique(ids_);
    ids_.erase(repeated.begin(), repeated.end());
  }
  // The vertices v with mask[v] != 0.
  static PinnedVertices fromMask(std::span<const uint8_t> mask) {
    PinnedVertices pinned;
    for (uint32_t v = 0; v < mask.size(); ++v)
      if (mask[v]) pinned.ids_.push_back(v);
    return pinned;
  }

  // mask[v] is 1 for a pinned vertex and 0 for any other. All ids must be below `vertexCount`.
  std::vector<uint8_t> mask(uint32_t vertexCount) const {
    std::vector<uint8_t> isPinned(vertexCount, 0);
    for (const uint32_t v : ids_) isPinned[v] = 1;
    return isPinned;
  }

  const std::vector<uint32_t>& ids() const { return ids_; }
  bool empty() const { return ids_.empty(); }
  size_t size() const { return ids_.size(); }
  auto begin() const { return ids_.begin(); }
  auto end() const { return ids_.end(); }

  friend bool operator==(const PinnedVertices&, const PinnedVertices&) = default;

 private:
  std::vector<uint32_t> ids_;
};

}  // namespace limber
