#include "query/closest_point.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace limber {

namespace {

constexpr uint32_t kLeafSize = 2;
constexpr double kSameWay = 0.25;        // cosine between normals
constexpr double kBetweenSheets = 0.01;  // of the diagonal

// From a point to two boxes.
RealPair squaredDistance(const Point<RealPair>& p, const Point<RealPair>& low, const Point<RealPair>& high) {
  const auto outside = [](RealPair x, RealPair from, RealPair to) {
    const RealPair below = from - x, above = x - to, off = below > above ? below : above;
    return off > 0 ? off : RealPair{};
  };
  const RealPair x = outside(p.x, low.x, high.x), y = outside(p.y, low.y, high.y),
                 z = outside(p.z, low.z, high.z);
  return x * x + y * y + z * z;
}

void widen(Bounds& box, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], p[axis]);
    box.high[axis] = std::max(box.high[axis], p[axis]);
  }
}

// The parameter in [0, 1] of the point of the segment a + s (b - a) closest to p.
double closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double squares = squaredLength(b - a);
  return squares > 0 ? std::clamp(dot(p - a, b - a) / squares, 0.0, 1.0) : 0.0;
}

// Barycentric coordinates of the point of a triangle closest to p: its foot on the plane where that lies
// inside, else the closest of its three edges' closest points. Any triangle, needles and points included.
void closestBarycentric(const Vec3& p, const Vec3 (&corner)[3], double (&barycentric)[3]) {
  const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double squaredNormal = squaredLength(normal);
  if (squaredNormal > 0) {
    bool inside = true;
    for (int c = 0; c < 3; ++c) {
      const Vec3 &a = corner[(c + 1) % 3], &b = corner[(c + 2) % 3];
      barycentric[c] = dot(cross(b - a, p - a), normal) / squaredNormal;
      inside = inside && barycentric[c] >= 0;
    }
    if (inside) return;
  }
  double best = HUGE_VAL;
  double found[3] = {1, 0, 0};
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3;
    const double s = closestOnSegment(p, corner[c], corner[next]);
    const double distance = squaredLength(p - (corner[c] + (corner[next] - corner[c]) * s));
    if (distance >= best) continue;
    best = distance;
    found[c] = 1 - s;
    found[next] = s;
    found[(c + 2) % 3] = 0;
  }
  std::copy(found, found + 3, barycentric);
}

}  // namespace

ClosestPoint closestOnTriangle(const TriangleMesh& mesh, uint32_t t, const Vec3& point) {
  const Vec3 corner[3] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  ClosestPoint found;
  found.triangle = t;
  closestBarycentric(point, corner, found.barycentric);
  for (int c = 0; c < 3; ++c) found.position += corner[c] * found.barycentric[c];
  found.distance = length(found.position - point);
  return found;
}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangleCount()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vec3> centres(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    centres[t] = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3;
  nodes_.reserve(std::bit_ceil(1 + order_.size() / kLeafSize));
  if (!order_.empty()) root_ = build(0, mesh.triangleCount(), centres, box_);
}

Bounds ClosestPointTree::boxAround(uint32_t first, uint32_t count) const {
  const Vec3& corner = mesh_.corner(order_[first], 0);
  Bounds box{corner, corner};
  for (uint32_t i = first; i < first + count; ++i)
    for (int c = 0; c < 3; ++c) widen(box, mesh_.corner(order_[i], c));
  return box;
}

// At the median centre along the longest side of the centres' box; returns the first of the upper half.
uint32_t ClosestPointTree::halve(uint32_t first, uint32_t count, const std::vector<Vec3>& centres) {
  Bounds box{centres[order_[first]], centres[order_[first]]};
  for (uint32_t i = first; i < first + count; ++i) widen(box, centres[order_[i]]);
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](uint32_t a, uint32_t b) {
    return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
  });
  return first + count / 2;
}

// At most log2(n) calls deep.
ClosestPointTree::Branch ClosestPointTree::build(uint32_t first, uint32_t count,
                                                 const std::vector<Vec3>& centres, Bounds& box) {
  if (count <= kLeafSize) {
    box = boxAround(first, count);
    return {first, count};
  }
  const uint32_t middle = halve(first, count, centres);
  const auto index = static_cast<uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Bounds upper;
  const Branch below = build(first, middle - first, centres, box);
  const Branch above = build(middle, first + count - middle, centres, upper);
  nodes_[index] = {asPair(box.low, upper.low), asPair(box.high, upper.high), {below, above}};
  widen(box, upper.low);
  widen(box, upper.high);
  return {index, 0};
}

template <class Counts>
ClosestPoint ClosestPointTree::search(const Vec3& point, const ClosestPoint& start,
                                      const Counts& counts) const {
  ClosestPoint best = start;
  double bestSquared =
      start.triangle == kNone ? start.distance * start.distance : squaredLength(point - start.position);
  struct Visit {
    Branch branch;
    double squared;
  };
  const Point<RealPair> points = asPair(point, point);
  Visit stack[64];  // a balanced tree over 2^32 triangles is 32 deep
  int depth = 0;
  stack[depth++] = {root_, 0};
  while (depth > 0) {
    const auto [branch, away] = stack[--depth];
    if (away > bestSquared) continue;
    if (branch.count == 0) {
      const Node& node = nodes_[branch.first];
      const RealPair squared = squaredDistance(points, node.low, node.high);
      const int far = squared[1] < squared[0] ? 0 : 1;
      if (squared[far] <= bestSquared) stack[depth++] = {node.branches[far], squared[far]};
      if (squared[1 - far] <= bestSquared) stack[depth++] = {node.branches[1 - far], squared[1 - far]};
      continue;
    }
    for (uint32_t i = branch.first; i < branch.first + branch.count; ++i) {
      const uint32_t t = order_[i];
      if (t == start.triangle || !counts(t)) continue;
      const Vec3 corner[3] = {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
      double barycentric[3];
      closestBarycentric(point, corner, barycentric);
      const Vec3 position =
          corner[0] * barycentric[0] + corner[1] * barycentric[1] + corner[2] * barycentric[2];
      const double squared = squaredLength(point - position);
      if (squared > bestSquared || (squared == bestSquared && t > best.triangle)) continue;
      bestSquared = squared;
      best.triangle = t;
      best.position = position;
      std::copy(barycentric, barycentric + 3, best.barycentric);
    }
  }
  best.distance = std::sqrt(bestSquared);
  return best;
}

ClosestPoint ClosestPointTree::closest(const Vec3& point, uint32_t near) const {
  const ClosestPoint start =
      near == kNone ? ClosestPoint::within(HUGE_VAL) : closestOnTriangle(mesh_, near, point);
  return search(point, start, [](uint32_t) { return true; });
}

ClosestPoint ClosestPointTree::closestFacing(const Vec3& point, const Vec3& normal, uint32_t near) const {
  const auto looksThatWay = [&](uint32_t t) {
    return dot(normalized(areaNormal(mesh_, t)), normal) >= kSameWay;
  };
  const ClosestPoint any = closest(point, near);
  if (squaredLength(normal) == 0 || looksThatWay(any.triangle)) return any;
  const double slack = kBetweenSheets * box_.diagonal();
  const ClosestPoint facing = search(point, ClosestPoint::within(any.distance + slack), looksThatWay);
  return facing.triangle != kNone ? facing : any;
}

}  // namespace limber
