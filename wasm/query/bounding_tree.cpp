#include "query/bounding_tree.h"

#include <algorithm>
#include <bit>

#include "base/parallel.h"

namespace limber {
namespace {

constexpr uint32_t kLeafSize = 2;
constexpr size_t kItemsPerRange = 16384;
constexpr uint32_t kParallelItems = 8192;  // items above which both branches are built in parallel

std::array<float, 3> inFloats(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// The number of nodes of a tree over `count` items: one less than its leaves. Halving n, 2^d <= n / 2 < 2^(d
// + 1), for d levels gives 2^d ranges of 2, 3 or 4 items, and those of more than 2 have two leaves.
uint32_t nodesOver(uint32_t count) {
  if (count <= kLeafSize) return 0;
  const uint32_t ranges = std::bit_floor(count) / 2;
  return ranges + std::min(count - 2 * ranges, ranges) - 1;
}

}  // namespace

BoundingTree::BoundingTree(const std::vector<Bounds>& boxes, const std::vector<Vec3>& centres)
    : nodes_(nodesOver(static_cast<uint32_t>(boxes.size()))), order_(boxes.size()) {
  if (boxes.empty()) return;
  const auto count = static_cast<uint32_t>(boxes.size());
  Build from{std::vector<Item>(count), boxes};
  parallelFor(count, kItemsPerRange, [&](size_t begin, size_t end) {
    for (auto i = static_cast<uint32_t>(begin); i < end; ++i) from.items[i] = {inFloats(centres[i]), i};
  });
  root_ = build(from, {0, count, 0}, box_);
  parallelFor(count, kItemsPerRange, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) order_[i] = from.items[i].index;
  });
}

BoundingTree::BoundingTree(const std::vector<Bounds>& boxes, const std::vector<Vec3>& centres,
                           const std::vector<uint32_t>& itemOfPiece)
    : BoundingTree(boxes, centres) {
  for (uint32_t& piece : order_) piece = itemOfPiece[piece];
}

namespace {

// Splits at the median centre along the longest side of the centres' box; `middle` is the first item of the
// upper half.
template <class Iterator>
void halve(Iterator begin, Iterator middle, Iterator end) {
  std::array<float, 3> low = begin->centre, high = low;
  for (Iterator item = begin; item != end; ++item)
    for (size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], item->centre[k]);
      high[k] = std::max(high[k], item->centre[k]);
    }
  const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
  const size_t axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  std::nth_element(begin, middle, end, [axis](const auto& a, const auto& b) {
    return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis] : a.index < b.index;
  });
}

}  // namespace

// The recursion is at most log2(n) deep, because every call halves the items.
BoundingTree::Branch BoundingTree::build(Build& from, const Part& part, Bounds& box) {
  const auto [first, count, node] = part;
  const auto begin = from.items.begin() + first;
  if (count <= kLeafSize) {
    box = from.boxes[begin->index];
    for (uint32_t i = 0; i < count; ++i) box.include(from.boxes[begin[i].index]);
    return {first, count};
  }
  const uint32_t half = count / 2;
  halve(begin, begin + half, begin + count);
  const Part parts[2] = {{first, half, node + 1}, {first + half, count - half, node + 1 + nodesOver(half)}};
  Branch branches[2];
  Bounds own[2];
  const auto buildParts = [&](size_t low, size_t high) {
    for (size_t i = low; i < high; ++i) branches[i] = build(from, parts[i], own[i]);
  };
  if (count >= kParallelItems)
    parallelFor(2, 1, buildParts);
  else
    buildParts(0, 2);
  nodes_[node] = {
      asPair(own[0].low, own[1].low), asPair(own[0].high, own[1].high), {branches[0], branches[1]}};
  box = own[0];
  box.include(own[1]);
  return {node, 0};
}

}  // namespace limber
