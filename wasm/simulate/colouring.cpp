#include "simulate/colouring.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <random>
#include <utility>

#include "mesh/triangle_mesh.h"

namespace limber {

namespace {

std::vector<uint32_t> visitingOrder(uint32_t count, uint32_t order) {
  std::vector<uint32_t> visits(count);
  std::iota(visits.begin(), visits.end(), 0u);
  if (order == 0) return visits;
  std::mt19937 random(order);  // not std::shuffle, which differs between libraries
  for (uint32_t i = count; i > 1; --i) std::swap(visits[i - 1], visits[random() % i]);
  return visits;
}

// The colours of each vertex so far, 64 to a word.
class UsedColours {
 public:
  explicit UsedColours(uint32_t vertexCount) : words_(vertexCount) {}

  uint32_t firstFree(std::span<const uint32_t> vertices) const {
    for (size_t word = 0;; ++word) {
      uint64_t used = 0;
      for (const uint32_t v : vertices)
        if (v != kNone && word < words_[v].size()) used |= words_[v][word];
      if (used != UINT64_MAX) return static_cast<uint32_t>(64 * word + std::countr_one(used));
    }
  }
  void use(std::span<const uint32_t> vertices, uint32_t colour) {
    for (const uint32_t v : vertices) {
      if (v == kNone) continue;
      if (words_[v].size() <= colour / 64) words_[v].resize(colour / 64 + 1, 0);
      words_[v][colour / 64] |= uint64_t{1} << (colour % 64);
    }
  }

 private:
  std::vector<std::vector<uint64_t>> words_;
};

bool shareVertex(std::span<const uint32_t> one, std::span<const uint32_t> other) {
  return std::ranges::any_of(
      one, [&](uint32_t v) { return v != kNone && std::ranges::find(other, v) != other.end(); });
}

// Whether constraint i fits into a batch: a lane is empty and it shares no vertex with the others.
bool hasFreeLane(const Colouring::Batch& batch, uint32_t i, const Stencils& stencils) {
  return batch.back() == kNone && std::ranges::none_of(batch, [&](uint32_t j) {
           return j != kNone && shareVertex(stencils.of(i), stencils.of(j));
         });
}

// Appends the batches of a group, colour by colour. With `packs`, constraints that do not fill a batch of
// their colour are packed together at the end: an empty lane costs as much as a full one, and a body with
// many groups has many empty lanes.
void appendBatches(const std::vector<std::vector<uint32_t>>& colours, const Stencils& stencils, bool packs,
                   std::vector<Colouring::Batch>& batches) {
  std::vector<uint32_t> rest;
  for (const auto& members : colours) {
    const size_t whole = packs ? members.size() / 4 * 4 : members.size();
    for (size_t first = 0; first < whole; first += 4) {
      Colouring::Batch batch = {kNone, kNone, kNone, kNone};
      for (size_t k = 0; k < 4 && first + k < whole; ++k) batch[k] = members[first + k];
      batches.push_back(batch);
    }
    rest.insert(rest.end(), members.begin() + static_cast<ptrdiff_t>(whole), members.end());
  }
  const auto open = static_cast<ptrdiff_t>(batches.size());
  for (const uint32_t i : rest) {
    const auto batch = std::find_if(batches.begin() + open, batches.end(),
                                    [&](const auto& other) { return hasFreeLane(other, i, stencils); });
    if (batch == batches.end())
      batches.push_back({i, kNone, kNone, kNone});
    else
      *std::ranges::find(*batch, kNone) = i;
  }
}

}  // namespace

Colouring colour(const Stencils& stencils, const Blocks& blocks, uint32_t order) {
  const auto vertexCount = static_cast<uint32_t>(blocks.blockOf.size());
  UsedColours inBlocks(vertexCount), onBorders(vertexCount);
  std::vector<std::vector<std::vector<uint32_t>>> members(blocks.groupCount());  // by group and colour
  for (const uint32_t i : visitingOrder(stencils.count(), order)) {
    const auto own = stencils.of(i);
    const uint32_t group = blocks.groupOf(own);
    UsedColours& used = group < blocks.count() ? inBlocks : onBorders;
    const uint32_t colour = used.firstFree(own);
    used.use(own, colour);
    auto& colours = members[group];
    if (colour >= colours.size()) colours.resize(colour + 1);
    colours[colour].push_back(i);
  }
  Colouring colouring;
  for (const auto& colours : members) {
    colouring.groupStart.push_back(static_cast<uint32_t>(colouring.batches.size()));
    appendBatches(colours, stencils, blocks.count() > 1, colouring.batches);
  }
  colouring.groupStart.push_back(static_cast<uint32_t>(colouring.batches.size()));
  return colouring;
}

}  // namespace limber
