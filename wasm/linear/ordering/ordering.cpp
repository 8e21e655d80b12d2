#include "linear/ordering/ordering.h"

#include <algorithm>
#include <numeric>

#include "base/parallel.h"
#include "linear/ordering/minimum_degree.h"
#include "linear/ordering/separator.h"

namespace limber {

namespace {

constexpr size_t kLeafNodes = 10;  // heavy nodes: sets of at most this size are not cut any further
// Two halves are cut in parallel if together they have at least this many heavy nodes, and at least this
// fraction (one in kOneInApart) of the graph's, because each half takes memory of the size of the graph.
constexpr size_t kNodesApart = 4000, kOneInApart = 16;
constexpr uint32_t kNone = UINT32_MAX;

// A separator, or a leaf: a remainder that is not cut any further.
struct DissectionBlock {
  std::vector<uint32_t> nodes;
  uint32_t parent = kNone;  // the separator that cut it off from the rest
  uint32_t depth = 0;
  bool isLeaf = false;
};

// Adds the blocks of another dissection, whose roots become children of `parent`.
void append(std::vector<DissectionBlock>& blocks, std::vector<DissectionBlock> others, uint32_t parent) {
  const auto first = static_cast<uint32_t>(blocks.size());
  const uint32_t depth = blocks[parent].depth + 1;
  for (DissectionBlock& block : others) {
    block.parent = block.parent == kNone ? parent : block.parent + first;
    block.depth += depth;
    blocks.push_back(std::move(block));
  }
}

// Cuts a graph into blocks; parents precede their children.
class Dissector {
 public:
  Dissector(const NodeGraph& graph, const Job& job)
      : graph_(graph), job_(job), subgraph_(graph), reached_(graph.nodeCount(), 0) {}

  std::vector<DissectionBlock> run(std::vector<uint32_t> nodes) {
    divide(std::move(nodes), kNone, 0);
    return std::move(blocks_);
  }

 private:
  // Recursion is as deep as the tree, some tens of levels.
  void divide(std::vector<uint32_t> nodes, uint32_t parent, uint32_t depth) {
    std::vector<std::vector<uint32_t>> pieces = connectedPieces(nodes);
    nodes = {};
    for (auto& piece : pieces) divideConnected(std::move(piece), parent, depth);
  }

  void divideConnected(std::vector<uint32_t> nodes, uint32_t parent, uint32_t depth) {
    const auto block = static_cast<uint32_t>(blocks_.size());
    std::vector<uint32_t> half[3];
    if (nodes.size() > kLeafNodes) {
      const Sides sides = separate(subgraph_.of(nodes), job_);
      for (size_t k = 0; k < nodes.size(); ++k) half[sides[k]].push_back(nodes[k]);
    }
    const bool isLeaf = half[Left].empty() || half[Right].empty();
    blocks_.push_back({isLeaf ? std::move(nodes) : std::move(half[Between]), parent, depth, isLeaf});
    if (isLeaf) return;
    nodes = {};
    const size_t size = half[Left].size() + half[Right].size();
    if (size >= std::max<size_t>(kNodesApart, graph_.nodeCount() / kOneInApart))
      return divideApart(half, block);
    divide(std::move(half[Left]), block, depth + 1);
    divide(std::move(half[Right]), block, depth + 1);
  }

  // Both halves in parallel, each by a dissector of its own.
  void divideApart(std::vector<uint32_t> (&half)[3], uint32_t parent) {
    std::vector<DissectionBlock> found[2];
    parallelFor(2, 1, [&](size_t begin, size_t) {
      found[begin] = Dissector(graph_, job_).run(std::move(half[begin == 0 ? Left : Right]));
    });
    for (std::vector<DissectionBlock>& blocks : found) append(blocks_, std::move(blocks), parent);
  }

  // Splits nodes into connected components, ordered by the first node of each.
  std::vector<std::vector<uint32_t>> connectedPieces(const std::vector<uint32_t>& nodes) {
    const uint32_t inside = ++marks_, found = ++marks_;
    for (uint32_t i : nodes) reached_[i] = inside;
    std::vector<std::vector<uint32_t>> pieces;
    for (uint32_t seed : nodes) {
      if (reached_[seed] == found) continue;
      std::vector<uint32_t>& piece = pieces.emplace_back(1, seed);
      reached_[seed] = found;
      for (size_t head = 0; head < piece.size(); ++head)
        for (uint32_t j : graph_.around(piece[head]))
          if (reached_[j] == inside) {
            reached_[j] = found;
            piece.push_back(j);
          }
    }
    return pieces;
  }

  const NodeGraph& graph_;
  const Job& job_;
  Subgraph subgraph_;
  std::vector<uint32_t> reached_;
  uint32_t marks_ = 0;
  std::vector<DissectionBlock> blocks_;
};

uint32_t commonAncestor(const std::vector<DissectionBlock>& blocks, uint32_t a, uint32_t b) {
  while (a != b) {
    uint32_t& deeper = a != kNone && (b == kNone || blocks[a].depth >= blocks[b].depth) ? a : b;
    deeper = blocks[deeper].parent;
  }
  return a;
}

// The dissection of the heavy nodes, to which light nodes are added one by one.
struct Dissection {
  std::vector<DissectionBlock> blocks;
  std::vector<uint32_t> blockOf;  // per node; kNone while it has none
};

// The block that a light node joins: the deepest block of its heavy neighbours, or the common ancestor if a
// neighbour that already has a block lies on another branch. No two neighbours therefore end up on different
// branches.
uint32_t blockFor(uint32_t node, const NodeGraph& graph, const Dissection& dissection, uint32_t heaviest) {
  const auto& [blocks, blockOf] = dissection;
  uint32_t block = kNone;
  for (uint32_t j : graph.around(node))
    if (graph.weight[j] == heaviest && (block == kNone || blocks[blockOf[j]].depth > blocks[block].depth))
      block = blockOf[j];
  for (uint32_t j : graph.around(node)) {
    if (blockOf[j] == kNone) continue;
    const uint32_t common = commonAncestor(blocks, block, blockOf[j]);
    if (common != blockOf[j]) block = common;
  }
  return block;
}

// Dissects the heavy nodes and adds the light ones.
std::vector<DissectionBlock> dissect(const NodeGraph& graph, const Job& job) {
  const uint32_t heaviest = *std::max_element(graph.weight.begin(), graph.weight.end());
  std::vector<uint32_t> heavy;
  for (uint32_t i = 0; i < graph.nodeCount(); ++i)
    if (graph.weight[i] == heaviest) heavy.push_back(i);
  const NodeGraph heavyGraph = Subgraph(graph).of(heavy);
  std::vector<uint32_t> all(heavy.size());
  std::iota(all.begin(), all.end(), 0u);
  Dissection dissection{Dissector(heavyGraph, job).run(std::move(all)),
                        std::vector<uint32_t>(graph.nodeCount(), kNone)};
  auto& [blocks, blockOf] = dissection;
  for (uint32_t b = 0; b < blocks.size(); ++b)
    for (uint32_t& node : blocks[b].nodes) {
      node = heavy[node];
      blockOf[node] = b;
    }
  for (uint32_t i = 0; i < graph.nodeCount(); ++i) {
    if (graph.weight[i] == heaviest) continue;
    const uint32_t block = blockFor(i, graph, dissection, heaviest);
    blockOf[i] = block == kNone ? 0 : block;  // a node without neighbours may be in any block
    blocks[blockOf[i]].nodes.push_back(i);
  }
  return std::move(blocks);
}

}  // namespace

std::vector<uint32_t> eliminationOrder(const NodeGraph& graph, const Job& job) {
  if (graph.nodeCount() == 0) return {};
  const std::vector<DissectionBlock> blocks = dissect(graph, job);
  std::vector<uint32_t> order;
  MinimumDegree minimumDegree(graph);
  for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {  // children before parents
    if (block->isLeaf)
      minimumDegree.order(block->nodes, order);
    else
      order.insert(order.end(), block->nodes.begin(), block->nodes.end());
  }
  return order;
}

}  // namespace limber
