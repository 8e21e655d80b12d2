#pragma once

#include <cstdint>
#include <vector>

namespace limber {

// Maximum flow in a small directed graph (Dinic 1970).
class MaximumFlow {
 public:
  static constexpr int64_t kUnlimited = INT64_MAX / 4;

  explicit MaximumFlow(uint32_t nodeCount);

  void connect(uint32_t from, uint32_t to, int64_t capacity);
  // Finds the maximum flow. O(nodes^2 arcs) at worst, far less for the narrow bands that this is used for.
  void run(uint32_t source, uint32_t sink);

  // After `run`, per node: whether more could still flow to it from `source`, or from it to `sink`. The
  // border of the first set is the minimum cut nearest to the source, that of the second the one nearest to
  // the sink.
  std::vector<uint8_t> reachableFrom(uint32_t source) const { return residualSet(source, 0); }
  std::vector<uint8_t> leadingTo(uint32_t sink) const { return residualSet(sink, 1); }

 private:
  struct Arc {
    uint32_t to, next;  // next: the next arc of the list of arcs from the same node
    int64_t residual;   // capacity left
  };

  bool setLevels(uint32_t source, uint32_t sink);
  bool augment(uint32_t source, uint32_t sink);
  std::vector<uint8_t> residualSet(uint32_t from, uint32_t against) const;

  std::vector<uint32_t> first_, level_, current_, queue_, path_;
  std::vector<Arc> arcs_;  // the indices of an arc and its reverse differ in the last bit only
};

}  // namespace limber
