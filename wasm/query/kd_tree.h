#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/corner.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The point of triangle abc that is nearest to p: on its plane, or on the nearest of its edges.
Vec3 closestPoint(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

// A balanced kd-tree over items that have a centre and a bounding box: split at the median centre along the
// longest axis; every node knows the box around its items, so that searches by the distance to the items
// themselves, not to their centres, are exact.
class KdTree {
 public:
  KdTree() = default;
  // `boxes[i]` bounds item i.
  explicit KdTree(const std::vector<Bounds>& boxes);

  // The item of least rank; the tree must not be empty. `rankOf(item)` gives a rank that can be compared with
  // <, and `reach(rank)` the squared distance beyond which no item can have a lower one. `guess`, any item,
  // changes the time alone: the nearer it is the less is searched.
  template <class RankOf, class Reach>
  uint32_t nearest(const Vec3& p, uint32_t guess, const RankOf& rankOf, const Reach& reach) const;

  // Whether `isNear(item)` holds for any item whose box is within a squared distance of p; nearer ones are
  // asked first, and none after the first that says yes.
  template <class IsNear>
  bool any(const Vec3& p, double squaredDistance, const IsNear& isNear) const;

 private:
  static constexpr uint32_t kLeafSize = 8;
  static constexpr int kDepth = 32;  // of the deepest tree that 32-bit indices allow

  struct Node {
    Bounds box;
    uint32_t begin, end;  // of its items
    uint32_t right;       // its second child; the first follows the node itself; 0 in a leaf
  };

  uint32_t build(const std::vector<Bounds>& boxes, uint32_t begin, uint32_t end);
  static double squaredDistance(const Bounds& box, const Vec3& p) {
    const auto outside = [](double low, double high, double x) {
      return std::max(std::max(low - x, x - high), 0.0);
    };
    const double x = outside(box.low.x, box.high.x, p.x), y = outside(box.low.y, box.high.y, p.y),
                 z = outside(box.low.z, box.high.z, p.z);
    return x * x + y * y + z * z;
  }

  std::vector<Node> nodes_;
  std::vector<uint32_t> items_;
};

// The triangle of a mesh that is nearest to a point. Where several are equally near (to a millionth of the
// diagonal), as around a vertex, it is the one among them whose centre is nearest; then the lowest.
class NearestTriangle {
 public:
  NearestTriangle() = default;
  // Keeps a reference to `mesh`.
  explicit NearestTriangle(const TriangleMesh& mesh);

  // `guess`: any triangle, better a near one.
  uint32_t find(const Vec3& p, uint32_t guess) const;
  // Whether a triangle of the mesh lies within a squared distance of p.
  bool isWithin(const Vec3& p, double squaredDistance, uint32_t guess) const;
  // As `find` for a vertex of the mesh, found among the triangles around it; kNone if there are none.
  uint32_t findAround(uint32_t vertex, std::span<const Corner> star) const;

 private:
  Vec3 centre(uint32_t t) const;

  const TriangleMesh* mesh_ = nullptr;
  double step_ = 0;  // distances are told apart in steps of this length
  KdTree tree_;
};

// The vertex of a mesh that is nearest to a point; the lowest of several.
class NearestVertex {
 public:
  NearestVertex() = default;
  // Keeps a reference to `mesh`.
  explicit NearestVertex(const TriangleMesh& mesh);

  // `guess`: any vertex, better a near one.
  uint32_t find(const Vec3& p, uint32_t guess) const;

 private:
  const TriangleMesh* mesh_ = nullptr;
  KdTree tree_;
};

template <class RankOf, class Reach>
uint32_t KdTree::nearest(const Vec3& p, uint32_t guess, const RankOf& rankOf, const Reach& reach) const {
  struct Entry {
    uint32_t node;
    double squaredDistance;
  };
  std::array<Entry, kDepth> waiting;
  int count = 0;
  uint32_t best = guess;
  auto bestRank = rankOf(guess);
  double limit = reach(bestRank);
  waiting[count++] = {0, 0};
  while (count > 0) {
    const Entry entry = waiting[--count];
    if (entry.squaredDistance > limit) continue;
    const Node& node = nodes_[entry.node];
    if (node.right != 0) {
      const uint32_t left = entry.node + 1;
      const Entry toLeft{left, squaredDistance(nodes_[left].box, p)};
      const Entry toRight{node.right, squaredDistance(nodes_[node.right].box, p)};
      // The nearer child is searched first: it goes on top.
      const bool rightFirst = toRight.squaredDistance < toLeft.squaredDistance;
      waiting[count++] = rightFirst ? toLeft : toRight;
      waiting[count++] = rightFirst ? toRight : toLeft;
      continue;
    }
    for (uint32_t i = node.begin; i < node.end; ++i) {
      const auto rank = rankOf(items_[i]);
      if (!(rank < bestRank)) continue;
      best = items_[i];
      bestRank = rank;
      limit = reach(rank);
    }
  }
  return best;
}

template <class IsNear>
bool KdTree::any(const Vec3& p, double limit, const IsNear& isNear) const {
  std::array<uint32_t, kDepth> waiting;
  int count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (node.right == 0) {
      for (uint32_t i = node.begin; i < node.end; ++i)
        if (isNear(items_[i])) return true;
      continue;
    }
    const uint32_t left = index + 1;
    const double toLeft = squaredDistance(nodes_[left].box, p),
                 toRight = squaredDistance(nodes_[node.right].box, p);
    const bool rightFirst = toRight < toLeft;
    if (std::max(toLeft, toRight) <= limit) waiting[count++] = rightFirst ? left : node.right;
    if (std::min(toLeft, toRight) <= limit) waiting[count++] = rightFirst ? node.right : left;
  }
  return false;
}

}  // namespace limber
