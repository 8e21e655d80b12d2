#include "linear/ordering/separator.h"

#include <algorithm>
#include <cmath>

#include "linear/ordering/separator_tightening.h"

namespace limber {

namespace {

constexpr uint32_t kCoarsest = 60;     // nodes: coarsening ends at graphs of at most this size
constexpr uint32_t kSeeds = 4;         // attempts on the coarsest graph
constexpr int kTightenings = 3;        // at most, on each finer graph
constexpr double kMinShrinking = 0.9;  // coarsening ends if more than this share of the nodes is left

// Numbers the nodes in breadth-first order from `seed` and returns the last node.
uint32_t rankFrom(const NodeGraph& graph, uint32_t seed, std::vector<uint32_t>& rank) {
  rank.assign(graph.nodeCount(), UINT32_MAX);
  std::vector<uint32_t> queue = {seed};
  rank[seed] = 0;
  for (size_t head = 0; head < queue.size(); ++head)
    for (uint32_t j : graph.around(queue[head]))
      if (rank[j] == UINT32_MAX) {
        rank[j] = static_cast<uint32_t>(queue.size());
        queue.push_back(j);
      }
  return queue.back();
}

// The cheapest cut between two ranks, with the adjacent nodes on one side of it (a rim) as the separator. Cut
// c puts the nodes of rank below c on the left. A node of rank r with neighbours up to rank m lies on the
// left rim of the cuts r + 1 .. m.
Sides cutBetweenRanks(const NodeGraph& graph, const std::vector<uint32_t>& rank) {
  const uint32_t count = graph.nodeCount();
  std::vector<int64_t> below(count + 1, 0), leftRim(count + 1, 0), rightRim(count + 1, 0);
  std::vector<uint32_t> lowest(rank), highest(rank);
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t j : graph.around(i)) {
      lowest[i] = std::min(lowest[i], rank[j]);
      highest[i] = std::max(highest[i], rank[j]);
    }
    const int64_t weight = graph.weight[i];
    below[rank[i] + 1] += weight;
    leftRim[rank[i] + 1] += weight;
    leftRim[highest[i] + 1] -= weight;
    rightRim[lowest[i] + 1] += weight;
    rightRim[rank[i] + 1] -= weight;
  }
  for (uint32_t c = 1; c <= count; ++c) {
    below[c] += below[c - 1];
    leftRim[c] += leftRim[c - 1];
    rightRim[c] += rightRim[c - 1];
  }
  const int64_t total = below[count];
  double best = HUGE_VAL;
  uint32_t cut = 1;
  bool isLeftRim = true;
  for (uint32_t c = 1; c < count; ++c) {
    const double left = cutCost(below[c] - leftRim[c], total - below[c], leftRim[c]);
    const double right = cutCost(below[c], total - below[c] - rightRim[c], rightRim[c]);
    if (std::min(left, right) >= best) continue;
    best = std::min(left, right);
    cut = c;
    isLeftRim = left <= right;
  }
  Sides sides(count);
  for (uint32_t i = 0; i < count; ++i) {
    const bool isLeft = rank[i] < cut;
    const bool isRim = isLeft == isLeftRim && (isLeft ? highest[i] >= cut : lowest[i] < cut);
    sides[i] = isRim ? Between : isLeft ? Left : Right;
  }
  return sides;
}

// Cuts a small graph by ranks from several seeds, each far from the previous one, and returns the cheapest
// cut. All nodes are Left if there is none.
Sides separateDirectly(const NodeGraph& graph) {
  Sides best(graph.nodeCount(), Left);
  double lowest = HUGE_VAL;
  std::vector<uint32_t> rank;
  uint32_t seed = 0;
  for (uint32_t k = 0; k < kSeeds; ++k) {
    const uint32_t last = rankFrom(graph, seed, rank);
    seed = k % 2 == 0 ? last : graph.nodeCount() * k / kSeeds;
    Sides sides = cutBetweenRanks(graph, rank);
    tightenSeparator(graph, sides);
    const double reached = separatorCost(graph, sides);
    if (reached >= lowest) continue;
    lowest = reached;
    best = std::move(sides);
  }
  return best;
}

// The cut of a coarsened graph, transferred to the graph itself and tightened.
Sides refined(const NodeGraph& graph, const std::vector<uint32_t>& coarseOf, const Sides& coarseSides) {
  Sides sides(graph.nodeCount());
  for (uint32_t i = 0; i < graph.nodeCount(); ++i) sides[i] = coarseSides[coarseOf[i]];
  int step = 0;
  while (step < kTightenings && tightenSeparator(graph, sides)) ++step;
  return sides;
}

}  // namespace

Sides separate(const NodeGraph& graph, const Job& job) {
  job.check();
  if (graph.nodeCount() > kCoarsest) {
    std::vector<uint32_t> coarseOf;
    const NodeGraph coarse = coarsened(graph, coarseOf);
    if (coarse.nodeCount() < kMinShrinking * graph.nodeCount()) {
      const Sides coarseSides = separate(coarse, job);
      if (std::ranges::count(coarseSides, Right) > 0) return refined(graph, coarseOf, coarseSides);
    }
  }
  return separateDirectly(graph);
}

}  // namespace limber
