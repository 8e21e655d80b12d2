#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linear/stiffness_model.h"

namespace limber {

// Nodes with a weight each, and which of them are coupled.
struct NodeGraph {
  std::vector<uint32_t> start, neighbours;  // of node i: neighbours[start[i] .. start[i + 1])
  std::vector<uint32_t> bond;               // [k]: how many couplings neighbours[k] stands for
  std::vector<uint32_t> weight;             // unknowns

  uint32_t nodeCount() const { return static_cast<uint32_t>(weight.size()); }
  std::span<const uint32_t> around(uint32_t i) const {
    return {neighbours.data() + start[i], start[i + 1] - start[i]};
  }
};

// The nodes of a model, weighing as much as they have unknowns.
NodeGraph nodeGraph(const StiffnessModel& model);

// Cuts graphs out of a graph, again and again, without new memory of the graph's size.
class Subgraph {
 public:
  explicit Subgraph(const NodeGraph& graph);  // must outlive it

  // Node k of the result is nodes[k]; neighbours that are not in the list are left out.
  NodeGraph of(const std::vector<uint32_t>& nodes);

 private:
  const NodeGraph& graph_;
  std::vector<uint32_t> localOf_;
};

// A graph of about half the nodes: pairs of neighbours with the strongest bond become one (heavy-edge
// matching, Karypis and Kumar 1998). `coarseOf` receives the new node of each.
NodeGraph coarsened(const NodeGraph& graph, std::vector<uint32_t>& coarseOf);

}  // namespace limber
