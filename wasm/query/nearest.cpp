#include "query/nearest.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "query/closest_point.h"

namespace limber {
namespace {

// Of the diagonal: a few times the resolution of float32 coordinates.
constexpr double kDistanceStep = 1e-6;

// The order of items: ranks `of(item)`, compared by <, and the squared distance `squaredLimit(rank)` beyond
// which no item can have a lower rank.
template <class Of, class SquaredLimit>
struct Ranking {
  Of of;
  SquaredLimit squaredLimit;
};

// The item of lowest rank. `guess` is any item; a close one saves time.
template <class Of, class SquaredLimit>
uint32_t leastOf(const BoundingTree& tree, const Vec3& p, uint32_t guess,
                 const Ranking<Of, SquaredLimit>& ranking) {
  uint32_t best = guess;
  auto bestRank = ranking.of(guess);
  double limit = ranking.squaredLimit(bestRank);
  tree.forEachWithin(p, limit, [&](uint32_t item) {
    const auto rank = ranking.of(item);
    if (!(rank < bestRank)) return limit;
    best = item;
    bestRank = rank;
    return limit = ranking.squaredLimit(rank);
  });
  return best;
}

}  // namespace

NearestTriangle::NearestTriangle(const TriangleMesh& mesh)
    : mesh_(&mesh), step_(kDistanceStep * bounds(mesh).diagonal()), tree_(treeOver(mesh)) {}

double NearestTriangle::squaredDistance(const Vec3& p, uint32_t t) const {
  return squaredLength(p - closestPosition(p, mesh_->corner(t, 0), mesh_->corner(t, 1), mesh_->corner(t, 2)));
}

uint32_t NearestTriangle::find(const Vec3& p, uint32_t guess) const {
  // Triangles are ranked by their distance in steps, then by the distance of their centres, then by index.
  const auto rankOf = [&](uint32_t t) {
    const double steps = std::floor(std::sqrt(squaredDistance(p, t)) / step_);
    return std::tuple(steps, squaredLength(p - triangleCentre(*mesh_, t)), t);
  };
  const auto squaredLimit = [&](const auto& rank) {
    const double distance = (std::get<0>(rank) + 1) * step_;
    return distance * distance;
  };
  return leastOf(tree_, p, guess, Ranking{rankOf, squaredLimit});
}

bool NearestTriangle::isWithin(const Vec3& p, double limit, uint32_t guess) const {
  bool found = squaredDistance(p, guess) <= limit;
  if (found) return true;
  tree_.forEachWithin(p, limit, [&](uint32_t t) {
    found = squaredDistance(p, t) <= limit;
    return found ? -1 : limit;
  });
  return found;
}

uint32_t NearestTriangle::findAround(uint32_t vertex, std::span<const Corner> star) const {
  const Vec3& p = mesh_->positions[vertex];
  const auto rankOf = [&](Corner corner) {
    const uint32_t t = corner.triangle();
    return std::tuple(squaredLength(p - triangleCentre(*mesh_, t)), t);
  };
  const auto nearest = std::ranges::min_element(star, {}, rankOf);
  return nearest == star.end() ? kNone : nearest->triangle();
}

NearestVertex::NearestVertex(const TriangleMesh& mesh) : mesh_(&mesh) {
  std::vector<Bounds> boxes;
  boxes.reserve(mesh.vertexCount());
  for (const Vec3& p : mesh.positions) boxes.push_back({p, p});
  tree_ = BoundingTree(boxes, mesh.positions);
}

uint32_t NearestVertex::find(const Vec3& p, uint32_t guess) const {
  const auto rankOf = [&](uint32_t v) { return std::tuple(squaredLength(p - mesh_->positions[v]), v); };
  const auto squaredLimit = [](const auto& rank) { return std::get<0>(rank); };
  return leastOf(tree_, p, guess, Ranking{rankOf, squaredLimit});
}

}  // namespace limber
