#include "linear/ordering/minimum_degree.h"

#include <algorithm>
#include <bit>

namespace limber {

namespace {

constexpr uint32_t kNowhere = UINT32_MAX;

void setBit(uint64_t* row, uint32_t k) {
  row[k / 64] |= uint64_t{1} << (k % 64);
}
void clearBit(uint64_t* row, uint32_t k) {
  row[k / 64] &= ~(uint64_t{1} << (k % 64));
}

}  // namespace

MinimumDegree::MinimumDegree(const NodeGraph& graph) : graph_(graph), localOf_(graph.nodeCount(), kNowhere) {}

void MinimumDegree::buildRows(const std::vector<uint32_t>& nodes) {
  members_ = nodes;
  for (uint32_t k = 0; k < nodes.size(); ++k) localOf_[nodes[k]] = k;
  for (uint32_t i : nodes)
    for (uint32_t j : graph_.around(i))
      if (localOf_[j] == kNowhere) {
        localOf_[j] = static_cast<uint32_t>(members_.size());
        members_.push_back(j);
      }
  words_ = (members_.size() + 63) / 64;
  bits_.assign(nodes.size() * words_, 0);
  uint32_t heaviest = 0;
  for (uint32_t i : members_) heaviest = std::max(heaviest, graph_.weight[i]);
  weightBits_.assign(std::bit_width(heaviest), std::vector<uint64_t>(words_, 0));
  for (uint32_t k = 0; k < members_.size(); ++k)
    for (size_t plane = 0; plane < weightBits_.size(); ++plane)
      if (graph_.weight[members_[k]] >> plane & 1) setBit(weightBits_[plane].data(), k);
  for (uint32_t k = 0; k < nodes.size(); ++k)
    for (uint32_t j : graph_.around(nodes[k])) setBit(row(k), localOf_[j]);
}

uint32_t MinimumDegree::degree(uint32_t i) const {
  const uint64_t* row = bits_.data() + size_t{i} * words_;
  uint32_t sum = 0;
  for (size_t plane = 0; plane < weightBits_.size(); ++plane) {
    uint32_t count = 0;
    for (size_t w = 0; w < words_; ++w)
      count += static_cast<uint32_t>(std::popcount(row[w] & weightBits_[plane][w]));
    sum += count << plane;
  }
  return sum;
}

// Couples all neighbours of `pivot` with each other and updates their degrees.
void MinimumDegree::eliminate(uint32_t pivot) {
  const uint64_t* from = row(pivot);
  for (size_t w = 0; w < words_; ++w)
    for (uint64_t left = from[w]; left != 0; left &= left - 1) {
      const auto j = static_cast<uint32_t>(64 * w) + static_cast<uint32_t>(std::countr_zero(left));
      if (j >= degree_.size()) return;  // a neighbour of the set, which is not eliminated here
      uint64_t* to = row(j);
      for (size_t k = 0; k < words_; ++k) to[k] |= from[k];
      clearBit(to, j);
      clearBit(to, pivot);
      degree_[j] = degree(j);
    }
}

void MinimumDegree::order(const std::vector<uint32_t>& nodes, std::vector<uint32_t>& order) {
  buildRows(nodes);
  const auto count = static_cast<uint32_t>(nodes.size());
  degree_.resize(count);
  for (uint32_t k = 0; k < count; ++k) degree_[k] = degree(k);
  for (uint32_t step = 0; step < count; ++step) {
    const auto pivot =
        static_cast<uint32_t>(std::min_element(degree_.begin(), degree_.end()) - degree_.begin());
    eliminate(pivot);
    degree_[pivot] = UINT32_MAX;
    order.push_back(nodes[pivot]);
  }
  for (uint32_t i : members_) localOf_[i] = kNowhere;
}

}  // namespace limber
