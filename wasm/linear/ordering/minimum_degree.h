#pragma once

#include <cstdint>
#include <vector>

#include "linear/ordering/node_graph.h"

namespace limber {

// Orders a small set of nodes by exact minimum degree (Tinney and Walker 1967): the next pivot is always the
// node that is coupled to the fewest unknowns, ties by index. Neighbours outside the set, which are
// eliminated later, count as well, as they do in the factor.
class MinimumDegree {
 public:
  explicit MinimumDegree(const NodeGraph& graph);  // the graph must outlive the object

  // Appends `nodes` to `order`. O(n^2) memory and O(n^3 / 64) time, meant for at most a few hundred nodes.
  void order(const std::vector<uint32_t>& nodes, std::vector<uint32_t>& order);

 private:
  using Row = uint64_t*;  // the neighbours of a node, one bit per member

  void buildRows(const std::vector<uint32_t>& nodes);
  uint32_t degree(uint32_t row) const;
  void eliminate(uint32_t row);
  Row row(uint32_t i) { return bits_.data() + size_t{i} * words_; }

  const NodeGraph& graph_;
  std::vector<uint32_t> localOf_;  // index in members_; UINT32_MAX for other nodes
  std::vector<uint32_t> members_;  // the set, followed by its neighbours
  size_t words_ = 0;
  std::vector<uint64_t> bits_;
  std::vector<std::vector<uint64_t>> weightBits_;  // weightBits_[k] marks the members whose weight has bit k
  std::vector<uint32_t> degree_;
};

}  // namespace limber
