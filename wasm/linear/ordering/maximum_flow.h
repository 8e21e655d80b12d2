#pragma once

#include <cstdint>
#include <vector>

namespace limber {

// Maximum flow on a small directed graph (Dinic 1970).
class MaximumFlow {
 public:
  static constexpr int64_t kUnlimited = INT64_MAX / 4;

  explicit MaximumFlow(uint32_t nodeCount);

  void connect(uint32_t from, uint32_t to, int64_t capacity);
  // O(nodes^2 arcs) at the worst, much less on the bands of a mesh.
  void run(uint32_t source, uint32_t sink);

  // After `run`: the nodes that more could flow to from `source`, and those from which more could flow to
  // `sink`. Each set's border is a minimum cut, the nearest to the source and the nearest to the sink.
  std::vector<uint8_t> reachableFrom(uint32_t source) const { return reach(source, 0); }
  std::vector<uint8_t> reaching(uint32_t sink) const { return reach(sink, 1); }

 private:
  struct Arc {
    uint32_t to, next;  // next: another arc from the same node
    int64_t room;
  };

  bool setLevels(uint32_t source, uint32_t sink);
  bool augment(uint32_t source, uint32_t sink);
  std::vector<uint8_t> reach(uint32_t from, uint32_t against) const;

  std::vector<uint32_t> first_, level_, current_, queue_, path_;
  std::vector<Arc> arcs_;  // an arc and its opposite are neighbours: their indices differ in the last bit
};

}  // namespace limber
