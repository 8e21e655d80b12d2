#include "query/bounding_tree.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace limber {
namespace {

constexpr uint32_t kLeafSize = 2;

}  // namespace

BoundingTree::BoundingTree(const std::vector<Bounds>& boxes, const std::vector<Vec3>& centres)
    : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(std::bit_ceil(1 + order_.size() / kLeafSize));
  if (!order_.empty()) root_ = build(0, static_cast<uint32_t>(order_.size()), boxes, centres, box_);
}

// Splits at the median centre along the longest side of the centres' box; returns the first item of the upper
// half.
uint32_t BoundingTree::halve(uint32_t first, uint32_t count, const std::vector<Vec3>& centres) {
  Bounds box{centres[order_[first]], centres[order_[first]]};
  for (uint32_t i = first; i < first + count; ++i) box.include(centres[order_[i]]);
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](uint32_t a, uint32_t b) {
    return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
  });
  return first + count / 2;
}

// Recursion is at most log2(n) deep, for every call halves the items.
BoundingTree::Branch BoundingTree::build(uint32_t first, uint32_t count, const std::vector<Bounds>& boxes,
                                         const std::vector<Vec3>& centres, Bounds& box) {
  if (count <= kLeafSize) {
    box = boxes[order_[first]];
    for (uint32_t i = first; i < first + count; ++i) box.include(boxes[order_[i]]);
    return {first, count};
  }
  const uint32_t middle = halve(first, count, centres);
  const auto index = static_cast<uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Bounds upper;
  const Branch below = build(first, middle - first, boxes, centres, box);
  const Branch above = build(middle, first + count - middle, boxes, centres, upper);
  nodes_[index] = {asPair(box.low, upper.low), asPair(box.high, upper.high), {below, above}};
  box.include(upper);
  return {index, 0};
}

}  // namespace limber
