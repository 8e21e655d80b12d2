#include "query/kd_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace limber {
namespace {

Bounds joined(const Bounds& a, const Bounds& b) {
  Bounds box = a;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(a.low[axis], b.low[axis]);
    box.high[axis] = std::max(a.high[axis], b.high[axis]);
  }
  return box;
}

// Orders triangles by their distance in steps, then by the distance of their centres, then by index.
using TriangleRank = std::tuple<double, double, uint32_t>;
using VertexRank = std::tuple<double, uint32_t>;

// A millionth of the diagonal: a few times what float32 coordinates resolve.
constexpr double kDistanceStep = 1e-6;

}  // namespace

Vec3 closestPoint(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double area = squaredLength(n);
  // Barycentric weights of the foot point, times `area`.
  const double u = dot(cross(c - b, p - b), n), v = dot(cross(a - c, p - c), n), w = area - u - v;
  if (area > 0 && u >= 0 && v >= 0 && w >= 0) return (a * u + b * v + c * w) / area;

  Vec3 best = a;
  const std::array<std::array<const Vec3*, 2>, 3> edges{{{&a, &b}, {&b, &c}, {&c, &a}}};
  for (const auto& [from, to] : edges) {
    const Vec3 along = *to - *from;
    const double square = squaredLength(along);
    const double s = square > 0 ? std::clamp(dot(p - *from, along) / square, 0.0, 1.0) : 0;
    const Vec3 point = *from + along * s;
    if (squaredLength(p - point) < squaredLength(p - best)) best = point;
  }
  return best;
}

KdTree::KdTree(const std::vector<Bounds>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (!boxes.empty()) build(boxes, 0, static_cast<uint32_t>(boxes.size()));
}

// Recursion halves the items, so it is no deeper than their logarithm.
uint32_t KdTree::build(const std::vector<Bounds>& boxes, uint32_t begin, uint32_t end) {
  const auto index = static_cast<uint32_t>(nodes_.size());
  Bounds box = boxes[items_[begin]];
  for (uint32_t i = begin; i < end; ++i) box = joined(box, boxes[items_[i]]);
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= kLeafSize) return index;

  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  // Twice the centre along the axis, ties by index.
  const auto before = [&](uint32_t i, uint32_t j) {
    const double a = boxes[i].low[axis] + boxes[i].high[axis], b = boxes[j].low[axis] + boxes[j].high[axis];
    return a != b ? a < b : i < j;
  };
  const uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end, before);
  build(boxes, begin, middle);
  const uint32_t right = build(boxes, middle, end);
  nodes_[index].right = right;
  return index;
}

NearestTriangle::NearestTriangle(const TriangleMesh& mesh)
    : mesh_(&mesh), step_(kDistanceStep * bounds(mesh).diagonal()) {
  std::vector<Bounds> boxes(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    boxes[t] = {mesh.corner(t, 0), mesh.corner(t, 0)};
    for (int c = 1; c < 3; ++c) boxes[t] = joined(boxes[t], {mesh.corner(t, c), mesh.corner(t, c)});
  }
  tree_ = KdTree(boxes);
}

Vec3 NearestTriangle::centre(uint32_t t) const {
  return (mesh_->corner(t, 0) + mesh_->corner(t, 1) + mesh_->corner(t, 2)) / 3;
}

uint32_t NearestTriangle::find(const Vec3& p, uint32_t guess) const {
  const auto rankOf = [&](uint32_t t) {
    const Vec3 point = closestPoint(p, mesh_->corner(t, 0), mesh_->corner(t, 1), mesh_->corner(t, 2));
    const double steps = std::floor(length(p - point) / step_);
    return TriangleRank(steps, squaredLength(p - centre(t)), t);
  };
  const auto reach = [&](const TriangleRank& rank) {
    const double distance = (std::get<0>(rank) + 1) * step_;
    return distance * distance;
  };
  return tree_.nearest(p, guess, rankOf, reach);
}

bool NearestTriangle::isWithin(const Vec3& p, double squaredDistance, uint32_t guess) const {
  const auto isNear = [&](uint32_t t) {
    const Vec3 point = closestPoint(p, mesh_->corner(t, 0), mesh_->corner(t, 1), mesh_->corner(t, 2));
    return squaredLength(p - point) <= squaredDistance;
  };
  return isNear(guess) || tree_.any(p, squaredDistance, isNear);
}

uint32_t NearestTriangle::findAround(uint32_t vertex, std::span<const Corner> star) const {
  const Vec3& p = mesh_->positions[vertex];
  const auto rankOf = [&](Corner corner) {
    const uint32_t t = corner.triangle();
    return std::tuple(squaredLength(p - centre(t)), t);
  };
  const auto nearest = std::ranges::min_element(star, {}, rankOf);
  return nearest == star.end() ? kNone : nearest->triangle();
}

NearestVertex::NearestVertex(const TriangleMesh& mesh) : mesh_(&mesh) {
  std::vector<Bounds> boxes;
  boxes.reserve(mesh.vertexCount());
  for (const Vec3& p : mesh.positions) boxes.push_back({p, p});
  tree_ = KdTree(boxes);
}

uint32_t NearestVertex::find(const Vec3& p, uint32_t guess) const {
  const auto rankOf = [&](uint32_t v) { return VertexRank(squaredLength(p - mesh_->positions[v]), v); };
  const auto reach = [](const VertexRank& rank) { return std::get<0>(rank); };
  return tree_.nearest(p, guess, rankOf, reach);
}

}  // namespace limber
