#include "linear/ordering/ordering.h"

#include <algorithm>
#include <numeric>

#include "linear/ordering/minimum_degree.h"
#include "linear/ordering/separator.h"

namespace limber {

namespace {

constexpr size_t kLeafNodes = 10;  // heavy ones: fewer are not cut any further
constexpr uint32_t kNone = UINT32_MAX;

// A separator, or a remainder that is not cut any further.
struct Part {
  std::vector<uint32_t> nodes;
  uint32_t parent = kNone;  // the separator that cut it off
  uint32_t depth = 0;
  bool isLeaf = false;
};

// Cuts a graph into parts; parents stand before their children.
class Dissector {
 public:
  Dissector(const NodeGraph& graph, const Job& job)
      : graph_(graph), job_(job), subgraph_(graph), reached_(graph.nodeCount(), 0) {}

  std::vector<Part> run(std::vector<uint32_t> nodes) {
    divide(std::move(nodes), kNone, 0);
    return std::move(parts_);
  }

 private:
  // Recursion is as deep as the tree, some tens of levels.
  void divide(std::vector<uint32_t> nodes, uint32_t parent, uint32_t depth) {
    std::vector<std::vector<uint32_t>> pieces = connectedPieces(nodes);
    nodes = {};
    for (auto& piece : pieces) divideConnected(std::move(piece), parent, depth);
  }

  void divideConnected(std::vector<uint32_t> nodes, uint32_t parent, uint32_t depth) {
    const auto part = static_cast<uint32_t>(parts_.size());
    std::vector<uint32_t> half[3];
    if (nodes.size() > kLeafNodes) {
      const Sides sides = separate(subgraph_.of(nodes), job_);
      for (size_t k = 0; k < nodes.size(); ++k) half[sides[k]].push_back(nodes[k]);
    }
    const bool isLeaf = half[Left].empty() || half[Right].empty();
    parts_.push_back({isLeaf ? std::move(nodes) : std::move(half[Between]), parent, depth, isLeaf});
    if (isLeaf) return;
    nodes = {};
    divide(std::move(half[Left]), part, depth + 1);
    divide(std::move(half[Right]), part, depth + 1);
  }

  // The nodes by connected piece, in the order in which the pieces come first.
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
  std::vector<Part> parts_;
};

uint32_t commonAncestor(const std::vector<Part>& parts, uint32_t a, uint32_t b) {
  while (a != b) {
    uint32_t& deeper = a != kNone && (b == kNone || parts[a].depth >= parts[b].depth) ? a : b;
    deeper = parts[deeper].parent;
  }
  return a;
}

// Where a light node goes: to the deepest part of its heavy neighbours, or, if some neighbour that has a part
// already lies on another branch, to where the branches meet. So no two neighbours end up on different
// branches.
uint32_t partFor(uint32_t node, const NodeGraph& graph, const std::vector<Part>& parts,
                 const std::vector<uint32_t>& partOf, uint32_t heaviest) {
  uint32_t part = kNone;
  for (uint32_t j : graph.around(node))
    if (graph.weight[j] == heaviest && (part == kNone || parts[partOf[j]].depth > parts[part].depth))
      part = partOf[j];
  for (uint32_t j : graph.around(node)) {
    if (partOf[j] == kNone) continue;
    const uint32_t common = commonAncestor(parts, part, partOf[j]);
    if (common != partOf[j]) part = common;
  }
  return part;
}

// The dissection of the heavy nodes, with the light ones where they belong.
std::vector<Part> dissect(const NodeGraph& graph, const Job& job) {
  const uint32_t heaviest = *std::max_element(graph.weight.begin(), graph.weight.end());
  std::vector<uint32_t> heavy;
  for (uint32_t i = 0; i < graph.nodeCount(); ++i)
    if (graph.weight[i] == heaviest) heavy.push_back(i);
  const NodeGraph heavyGraph = Subgraph(graph).of(heavy);
  std::vector<uint32_t> all(heavy.size());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<Part> parts = Dissector(heavyGraph, job).run(std::move(all));
  std::vector<uint32_t> partOf(graph.nodeCount(), kNone);
  for (uint32_t p = 0; p < parts.size(); ++p)
    for (uint32_t& node : parts[p].nodes) {
      node = heavy[node];
      partOf[node] = p;
    }
  for (uint32_t i = 0; i < graph.nodeCount(); ++i) {
    if (graph.weight[i] == heaviest) continue;
    const uint32_t part = partFor(i, graph, parts, partOf, heaviest);
    partOf[i] = part == kNone ? 0 : part;  // without neighbours: anywhere
    parts[partOf[i]].nodes.push_back(i);
  }
  return parts;
}

}  // namespace

std::vector<uint32_t> eliminationOrder(const NodeGraph& graph, const Job& job) {
  if (graph.nodeCount() == 0) return {};
  const std::vector<Part> parts = dissect(graph, job);
  std::vector<uint32_t> order;
  MinimumDegree minimumDegree(graph);
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {  // children before parents
    if (part->isLeaf)
      minimumDegree.order(part->nodes, order);
    else
      order.insert(order.end(), part->nodes.begin(), part->nodes.end());
  }
  return order;
}

}  // namespace limber
