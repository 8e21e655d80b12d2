#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linear/sparse_pencil.h"

namespace limber {

// A weighted undirected graph, in compressed adjacency lists.
struct NodeGraph {
  std::vector<uint32_t> start, neighbours;  // node i has neighbours[start[i] .. start[i + 1])
  std::vector<uint32_t> bond;    // bond[k]: how many original edges the edge to neighbours[k] represents
  std::vector<uint32_t> weight;  // per node: its unknowns

  uint32_t nodeCount() const { return static_cast<uint32_t>(weight.size()); }
  std::span<const uint32_t> around(uint32_t i) const {
    return {neighbours.data() + start[i], start[i + 1] - start[i]};
  }
};

// The graph of a pencil: its nodes, weighted by their numbers of unknowns, and their couplings in K.
NodeGraph nodeGraph(const SparsePencil& pencil);

// Extracts any number of subgraphs without allocating memory of the size of the whole graph each time.
class Subgraph {
 public:
  explicit Subgraph(const NodeGraph& graph);  // must outlive it

  // The subgraph of `nodes`, renumbered: its node k is nodes[k]. Neighbours outside the list are dropped.
  NodeGraph of(const std::vector<uint32_t>& nodes);

 private:
  const NodeGraph& graph_;
  std::vector<uint32_t> localOf_;
};

// A graph with about half the nodes: neighbours with the strongest bond are merged in pairs (heavy-edge
// matching, Karypis and Kumar 1998). `coarseOf` receives the coarse node of each node.
NodeGraph coarsened(const NodeGraph& graph, std::vector<uint32_t>& coarseOf);

}  // namespace limber
