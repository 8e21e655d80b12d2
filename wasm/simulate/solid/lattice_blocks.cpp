#include "simulate/solid/lattice_blocks.h"

#include <algorithm>

#include "base/disjoint_sets.h"

namespace limber {

namespace {

// Appends the connected part of a node to an order, breadth first from that node. A part can be passed over a
// second time, from another node.
class NodeSearch {
 public:
  NodeSearch(std::span<const LatticeCell> cells, uint32_t nodeCount)
      : cells_(cells), start_(nodeCount + 1, 0), pass_(nodeCount, 0) {
    for (const LatticeCell& cell : cells)
      for (const uint32_t node : cell) ++start_[node + 1];
    for (uint32_t node = 0; node < nodeCount; ++node) start_[node + 1] += start_[node];
    around_.resize(start_.back());
    std::vector<uint32_t> next(start_.begin(), start_.end() - 1);
    for (uint32_t cell = 0; cell < cells.size(); ++cell)
      for (const uint32_t node : cells[cell]) around_[next[node]++] = cell;
  }

  void append(uint32_t first, std::vector<uint32_t>& order) {
    const uint32_t pass = pass_[first] + 1;
    pass_[first] = pass;
    order.push_back(first);
    for (size_t next = order.size() - 1; next < order.size(); ++next) {
      const uint32_t node = order[next];
      for (uint32_t i = start_[node]; i < start_[node + 1]; ++i)
        for (const uint32_t other : cells_[around_[i]]) {
          if (pass_[other] == pass) continue;
          pass_[other] = pass;
          order.push_back(other);
        }
    }
  }
  bool isNew(uint32_t node) const { return pass_[node] == 0; }

 private:
  std::span<const LatticeCell> cells_;
  std::vector<uint32_t> start_,
      around_;  // cells around node n: around_[start_[n]] to around_[start_[n + 1] - 1]
  std::vector<uint32_t> pass_;
};

}  // namespace

std::vector<uint32_t> nodesFromEndToEnd(std::span<const LatticeCell> cells, uint32_t nodeCount) {
  NodeSearch search(cells, nodeCount);
  std::vector<uint32_t> order;
  order.reserve(nodeCount);
  for (uint32_t node = 0; node < nodeCount; ++node) {
    if (!search.isNew(node)) continue;
    const size_t part = order.size();
    search.append(node, order);
    const uint32_t end = order.back();
    order.resize(part);
    search.append(end, order);
  }
  return order;
}

Blocks latticeBlocks(std::span<const LatticeCell> cells, uint32_t nodeCount, uint32_t count) {
  Blocks blocks;
  blocks.blockOf.resize(nodeCount);
  for (uint32_t b = 0; b <= count; ++b)
    blocks.start.push_back(static_cast<uint32_t>(uint64_t{nodeCount} * b / count));
  for (uint32_t b = 0; b < count; ++b)
    std::fill(blocks.blockOf.begin() + blocks.start[b], blocks.blockOf.begin() + blocks.start[b + 1], b);
  blocks.borderOf.assign(nodeCount, kNone);
  DisjointSets sets(nodeCount);
  const auto crosses = [&](const LatticeCell& cell) {
    return std::ranges::any_of(
        cell, [&](uint32_t node) { return blocks.blockOf[node] != blocks.blockOf[cell[0]]; });
  };
  for (const LatticeCell& cell : cells)
    if (crosses(cell))
      for (const uint32_t node : cell) sets.unite(cell[0], node);
  for (const LatticeCell& cell : cells) {
    if (!crosses(cell)) continue;
    for (const uint32_t node : cell) {
      uint32_t& border = blocks.borderOf[sets.rootOf(node)];
      if (border == kNone) border = blocks.borderCount++;
      blocks.borderOf[node] = border;
    }
  }
  return blocks;
}

}  // namespace limber
