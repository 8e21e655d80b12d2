#include "linear/ordering/node_graph.h"

#include <algorithm>

namespace limber {

namespace {

constexpr uint32_t kNone = UINT32_MAX;

// Pairs each node with its free neighbour of the strongest bond, on a tie the lightest. A node without a free
// neighbour is its own partner.
std::vector<uint32_t> match(const NodeGraph& graph) {
  const uint32_t count = graph.nodeCount();
  std::vector<uint32_t> visit(count), partner(count, kNone);
  for (uint32_t i = 0; i < count; ++i) visit[i] = i;
  // Visiting in a scattered order prevents pairs that align with the numbering. The factor is Knuth's for
  // multiplicative hashing.
  const auto scatter = [](uint32_t i) { return (i + 1) * 2654435761u; };
  std::sort(visit.begin(), visit.end(), [&](uint32_t a, uint32_t b) { return scatter(a) < scatter(b); });
  for (uint32_t i : visit) {
    if (partner[i] != kNone) continue;
    uint32_t best = i, strongest = 0;
    for (uint32_t k = graph.start[i]; k < graph.start[i + 1]; ++k) {
      const uint32_t j = graph.neighbours[k];
      if (partner[j] != kNone || graph.bond[k] < strongest) continue;
      if (graph.bond[k] == strongest && graph.weight[j] >= graph.weight[best]) continue;
      strongest = graph.bond[k];
      best = j;
    }
    partner[i] = best;
    partner[best] = i;
  }
  return partner;
}

}  // namespace

NodeGraph nodeGraph(const SparsePencil& pencil) {
  std::vector<uint32_t> nodeOf(pencil.unknownCount());
  NodeGraph graph;
  graph.weight.resize(pencil.nodeCount());
  for (uint32_t i = 0; i < pencil.nodeCount(); ++i) {
    graph.weight[i] = pencil.firstUnknown[i + 1] - pencil.firstUnknown[i];
    for (uint32_t u = pencil.firstUnknown[i]; u < pencil.firstUnknown[i + 1]; ++u) nodeOf[u] = i;
  }
  graph.start.push_back(0);
  for (uint32_t i = 0; i < pencil.nodeCount(); ++i) {
    // All unknowns of a node have the same pattern, so the first one suffices.
    uint32_t last = i;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(pencil.k, pencil.firstUnknown[i]); entry; ++entry) {
      const uint32_t other = nodeOf[static_cast<size_t>(entry.row())];
      if (other != i && other != last) graph.neighbours.push_back(other);
      last = other;
    }
    graph.start.push_back(static_cast<uint32_t>(graph.neighbours.size()));
  }
  graph.bond.assign(graph.neighbours.size(), 1);
  return graph;
}

Subgraph::Subgraph(const NodeGraph& graph) : graph_(graph), localOf_(graph.nodeCount(), kNone) {}

NodeGraph Subgraph::of(const std::vector<uint32_t>& nodes) {
  NodeGraph sub;
  for (uint32_t k = 0; k < nodes.size(); ++k) localOf_[nodes[k]] = k;
  sub.start.push_back(0);
  for (uint32_t i : nodes) {
    for (uint32_t k = graph_.start[i]; k < graph_.start[i + 1]; ++k) {
      const uint32_t local = localOf_[graph_.neighbours[k]];
      if (local == kNone) continue;
      sub.neighbours.push_back(local);
      sub.bond.push_back(graph_.bond[k]);
    }
    sub.start.push_back(static_cast<uint32_t>(sub.neighbours.size()));
    sub.weight.push_back(graph_.weight[i]);
  }
  for (uint32_t i : nodes) localOf_[i] = kNone;
  return sub;
}

NodeGraph coarsened(const NodeGraph& graph, std::vector<uint32_t>& coarseOf) {
  const std::vector<uint32_t> partner = match(graph);
  coarseOf.assign(graph.nodeCount(), kNone);
  uint32_t count = 0;
  for (uint32_t i = 0; i < graph.nodeCount(); ++i)
    if (coarseOf[i] == kNone) coarseOf[i] = coarseOf[partner[i]] = count++;
  NodeGraph coarse;
  coarse.start.push_back(0);
  std::vector<uint32_t> slot(count, kNone);  // index of the coarse neighbour in the current list
  for (uint32_t i = 0; i < graph.nodeCount(); ++i) {
    if (partner[i] < i) continue;
    const uint32_t first = coarse.start.back();
    const auto add = [&](uint32_t member) {
      for (uint32_t k = graph.start[member]; k < graph.start[member + 1]; ++k) {
        const uint32_t j = coarseOf[graph.neighbours[k]];
        if (j == coarseOf[i]) continue;
        if (slot[j] == kNone || slot[j] < first) {
          slot[j] = static_cast<uint32_t>(coarse.neighbours.size());
          coarse.neighbours.push_back(j);
          coarse.bond.push_back(0);
        }
        coarse.bond[slot[j]] += graph.bond[k];
      }
    };
    add(i);
    if (partner[i] != i) add(partner[i]);
    coarse.start.push_back(static_cast<uint32_t>(coarse.neighbours.size()));
    coarse.weight.push_back(graph.weight[i] + (partner[i] != i ? graph.weight[partner[i]] : 0));
  }
  return coarse;
}

}  // namespace limber
