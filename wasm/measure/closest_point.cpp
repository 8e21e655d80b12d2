#include "measure/closest_point.h"

#include <algorithm>
#include <numeric>

namespace limber {

namespace {

constexpr uint32_t kLeafSize = 4;
constexpr double kSameWay = 0.25;        // cosine between normals
constexpr double kBetweenSheets = 0.01;  // of the diagonal

double squaredDistanceToBox(const Vec3& p, const Vec3& low, const Vec3& high) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double outside = std::max({low[axis] - p[axis], 0.0, p[axis] - high[axis]});
    sum += outside * outside;
  }
  return sum;
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

SurfacePoint closestOnTriangle(const TriangleMesh& mesh, uint32_t t, const Vec3& point) {
  const Vec3 corner[3] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  SurfacePoint found;
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
  nodes_.reserve(size_t{2} * mesh.triangleCount() / kLeafSize + 2);
  if (!order_.empty()) build(0, mesh.triangleCount(), centres);
}

// Halves the triangles at the median centre along the longest side of their centres' box: at most log2(n)
// calls deep.
uint32_t ClosestPointTree::build(uint32_t first, uint32_t count, std::vector<Vec3>& centres) {
  const auto index = static_cast<uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Vec3 low = mesh_.corner(order_[first], 0), high = low;
  Vec3 lowCentre = centres[order_[first]], highCentre = lowCentre;
  for (uint32_t i = first; i < first + count; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      for (int c = 0; c < 3; ++c) {
        low[axis] = std::min(low[axis], mesh_.corner(order_[i], c)[axis]);
        high[axis] = std::max(high[axis], mesh_.corner(order_[i], c)[axis]);
      }
      lowCentre[axis] = std::min(lowCentre[axis], centres[order_[i]][axis]);
      highCentre[axis] = std::max(highCentre[axis], centres[order_[i]][axis]);
    }
  nodes_[index].low = low;
  nodes_[index].high = high;
  if (count <= kLeafSize) {
    nodes_[index].first = first;
    nodes_[index].count = count;
    return index;
  }
  const Vec3 size = highCentre - lowCentre;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](uint32_t a, uint32_t b) {
    return centres[a][axis] != centres[b][axis] ? centres[a][axis] < centres[b][axis] : a < b;
  });
  build(first, count / 2, centres);
  nodes_[index].right = build(first + count / 2, count - count / 2, centres);
  return index;
}

template <class Counts>
SurfacePoint ClosestPointTree::search(const Vec3& point, const SurfacePoint& start,
                                      const Counts& counts) const {
  SurfacePoint best = start;
  double bestSquared =
      start.triangle == kNone ? start.distance * start.distance : squaredLength(point - start.position);
  struct Visit {
    uint32_t node;
    double squared;
  };
  Visit stack[64];  // a balanced tree over 2^32 triangles is 32 deep
  int depth = 0;
  stack[depth++] = {0, squaredDistanceToBox(point, nodes_[0].low, nodes_[0].high)};
  while (depth > 0) {
    const Visit visit = stack[--depth];
    if (visit.squared > bestSquared) continue;
    const Node& node = nodes_[visit.node];
    if (node.count == 0) {
      Visit near{visit.node + 1, 0}, far{node.right, 0};
      near.squared = squaredDistanceToBox(point, nodes_[near.node].low, nodes_[near.node].high);
      far.squared = squaredDistanceToBox(point, nodes_[far.node].low, nodes_[far.node].high);
      if (far.squared < near.squared) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
      continue;
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i) {
      const uint32_t t = order_[i];
      if (!counts(t)) continue;
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

SurfacePoint ClosestPointTree::closest(const Vec3& point, uint32_t near) const {
  const SurfacePoint start =
      near == kNone ? SurfacePoint{.distance = HUGE_VAL} : closestOnTriangle(mesh_, near, point);
  return search(point, start, [](uint32_t) { return true; });
}

SurfacePoint ClosestPointTree::closestFacing(const Vec3& point, const Vec3& normal, uint32_t near) const {
  const auto looksThatWay = [&](uint32_t t) {
    return dot(normalized(areaNormal(mesh_, t)), normal) >= kSameWay;
  };
  const SurfacePoint any = closest(point, near);
  if (squaredLength(normal) == 0 || looksThatWay(any.triangle)) return any;
  const double slack = kBetweenSheets * length(nodes_[0].high - nodes_[0].low);
  const SurfacePoint facing = search(point, {.distance = any.distance + slack}, looksThatWay);
  return facing.triangle != kNone ? facing : any;
}

}  // namespace limber
