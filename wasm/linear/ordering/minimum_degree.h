#pragma once

#include <cstdint>
#include <vector>

#include "linear/ordering/node_graph.h"

namespace limber {

// Orders a small set of nodes by exact minimum degree, in unknowns, ties by index. The nodes around the set
// (eliminated later) count as neighbours, as they do in the factor.
class MinimumDegree {
 public:
  explicit MinimumDegree(const NodeGraph& graph);  // must outlive it

  // Appends `nodes` to `order`. O(n^2) in time and memory: for some hundred nodes.
  void order(const std::vector<uint32_t>& nodes, std::vector<uint32_t>& order);

 private:
  using Row = uint64_t*;  // the neighbours of a node, one bit each

  void buildRows(const std::vector<uint32_t>& nodes);
  uint32_t degree(uint32_t row) const;
  void eliminate(uint32_t row);
  Row row(uint32_t i) { return bits_.data() + size_t{i} * words_; }

  const NodeGraph& graph_;
  std::vector<uint32_t> localOf_;  // of nodes in the set and around it; elsewhere UINT32_MAX
  std::vector<uint32_t> members_;  // the set, then what is around it
  size_t words_ = 0;
  std::vector<uint64_t> bits_;
  std::vector<std::vector<uint64_t>> weightBits_;  // [k]: the members whose weight has bit k
  std::vector<uint32_t> degree_;
};

}  // namespace limber
