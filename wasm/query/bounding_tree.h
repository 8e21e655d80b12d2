#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/real_pair.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A balanced hierarchy of bounding boxes over items 0 to n - 1 that have a centre and a box: split at the
// median centre along the longest axis. Every node stores the boxes of its two branches, so searches by the
// distance to the items themselves, not to their centres, are exact. Built once in O(n log n) by all threads,
// searched from any thread.
class BoundingTree {
 public:
  BoundingTree() = default;
  // `boxes[i]` bounds item i and `centres[i]` is its centre.
  BoundingTree(const std::vector<Bounds>& boxes, const std::vector<Vec3>& centres);
  // For items cut into pieces: box and centre i are those of a piece of item `itemOfPiece[i]`. Searches visit
  // an item once for each piece that is near.
  BoundingTree(const std::vector<Bounds>& boxes, const std::vector<Vec3>& centres,
               const std::vector<uint32_t>& itemOfPiece);

  // The box around all items.
  const Bounds& box() const { return box_; }

  // Visits the items whose boxes are not farther from p than a shrinking squared distance, nearer boxes
  // first. `visit(item)` returns the squared distance beyond which no further item matters; a negative one
  // ends the search. `squaredDistance` is the initial squared distance.
  template <class Visit>
  void forEachWithin(const Vec3& p, double squaredDistance, const Visit& visit) const;

 private:
  // The items order_[first] to order_[first + count - 1]; if count is 0, the two branches of nodes_[first].
  struct Branch {
    uint32_t first = 0, count = 0;
  };
  struct Node {
    Point<RealPair> low, high;  // corners of the boxes of both branches
    Branch branches[2];
  };
  // An item with its centre, stored together because the build reads both in order. Rounded to float: a
  // slightly different tree finds the same results.
  struct Item {
    std::array<float, 3> centre;
    uint32_t index;
  };
  // Temporary data of the build.
  struct Build {
    std::vector<Item> items;
    const std::vector<Bounds>& boxes;
  };
  // The items first .. first + count - 1, whose nodes are nodes_[node] and the following ones.
  struct Part {
    uint32_t first, count, node;
  };
  // Returns the branch over a part of the items, and writes its box.
  Branch build(Build& from, const Part& part, Bounds& box);

  // Squared distances of a point to two boxes.
  static RealPair squaredDistances(const Point<RealPair>& p, const Node& node) {
    const auto outside = [](RealPair x, RealPair from, RealPair to) {
      const RealPair below = from - x, above = x - to, off = below > above ? below : above;
      return off > 0 ? off : RealPair{};
    };
    const RealPair x = outside(p.x, node.low.x, node.high.x), y = outside(p.y, node.low.y, node.high.y),
                   z = outside(p.z, node.low.z, node.high.z);
    return x * x + y * y + z * z;
  }

  Branch root_;
  Bounds box_;
  std::vector<Node> nodes_;
  std::vector<uint32_t> order_;
};

template <class Visit>
void BoundingTree::forEachWithin(const Vec3& p, double squaredDistance, const Visit& visit) const {
  struct Entry {
    Branch branch;
    double squared;
  };
  if (order_.empty()) return;
  double limit = squaredDistance;
  const Point<RealPair> points = asPair(p, p);
  Entry stack[64];  // a balanced tree over 2^32 items is 32 deep
  int depth = 0;
  stack[depth++] = {root_, 0};
  while (depth > 0) {
    const auto [branch, away] = stack[--depth];
    if (away > limit) continue;
    if (branch.count == 0) {
      const Node& node = nodes_[branch.first];
      const RealPair squared = squaredDistances(points, node);
      const int far = squared[1] < squared[0] ? 0 : 1;
      // The nearer branch goes on top and is searched first.
      if (squared[far] <= limit) stack[depth++] = {node.branches[far], squared[far]};
      if (squared[1 - far] <= limit) stack[depth++] = {node.branches[1 - far], squared[1 - far]};
      continue;
    }
    for (uint32_t i = branch.first; i < branch.first + branch.count; ++i) {
      limit = visit(order_[i]);
      if (limit < 0) return;
    }
  }
}

}  // namespace limber
