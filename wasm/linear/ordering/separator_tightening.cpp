#include "linear/ordering/separator_tightening.h"

#include <algorithm>

#include "linear/ordering/maximum_flow.h"

namespace limber {

namespace {

constexpr uint32_t kNone = UINT32_MAX;
constexpr int kBandRings = 5;          // on each side of the separator
constexpr double kSmallestHalf = 0.4;  // of the total weight

struct Band {
  std::vector<uint32_t> nodes;
  std::vector<uint32_t> indexOf;  // per node of the graph: its index in `nodes`, or kNone
};

// The separator and the rings of nodes around it, as long as each half without them remains large enough.
Band bandAround(const NodeGraph& graph, const Sides& sides) {
  int64_t weight[3] = {};
  Band band;
  band.indexOf.assign(graph.nodeCount(), kNone);
  const auto add = [&](uint32_t i) {
    band.indexOf[i] = static_cast<uint32_t>(band.nodes.size());
    band.nodes.push_back(i);
  };
  for (uint32_t i = 0; i < graph.nodeCount(); ++i) {
    weight[sides[i]] += graph.weight[i];
    if (sides[i] == Between) add(i);
  }
  const double least = kSmallestHalf * static_cast<double>(weight[Left] + weight[Right] + weight[Between]);
  size_t head = 0;
  for (int ring = 0; ring < kBandRings; ++ring)
    for (const size_t end = band.nodes.size(); head < end; ++head)
      for (uint32_t j : graph.around(band.nodes[head])) {
        if (band.indexOf[j] != kNone) continue;
        if (static_cast<double>(weight[sides[j]] - graph.weight[j]) < least) continue;
        weight[sides[j]] -= graph.weight[j];
        add(j);
      }
  return band;
}

}  // namespace

bool tightenSeparator(const NodeGraph& graph, Sides& sides) {
  const Band band = bandAround(graph, sides);
  const auto count = static_cast<uint32_t>(band.nodes.size());
  // Node b of the band becomes an arc from 2 b to 2 b + 1 whose capacity is the weight of the node.
  const uint32_t source = 2 * count, sink = source + 1;
  MaximumFlow flow(2 * count + 2);
  for (uint32_t b = 0; b < count; ++b) {
    flow.connect(2 * b, 2 * b + 1, graph.weight[band.nodes[b]]);
    bool touches[3] = {};  // sides of its neighbours outside the band
    for (uint32_t j : graph.around(band.nodes[b])) {
      if (band.indexOf[j] == kNone)
        touches[sides[j]] = true;
      else
        flow.connect(2 * b + 1, 2 * band.indexOf[j], MaximumFlow::kUnlimited);
    }
    if (touches[Left]) flow.connect(source, 2 * b, MaximumFlow::kUnlimited);
    if (touches[Right]) flow.connect(2 * b + 1, sink, MaximumFlow::kUnlimited);
  }
  flow.run(source, sink);
  const auto fromSource = flow.reachableFrom(source), toSink = flow.leadingTo(sink);
  Sides nearLeft = sides, nearRight = sides;
  for (uint32_t b = 0; b < count; ++b) {
    nearLeft[band.nodes[b]] = fromSource[2 * b + 1] ? Left : fromSource[2 * b] ? Between : Right;
    nearRight[band.nodes[b]] = toSink[2 * b] ? Right : toSink[2 * b + 1] ? Between : Left;
  }
  const double left = separatorCost(graph, nearLeft), right = separatorCost(graph, nearRight);
  if (std::min(left, right) >= separatorCost(graph, sides)) return false;
  sides = left <= right ? std::move(nearLeft) : std::move(nearRight);
  return true;
}

}  // namespace limber
