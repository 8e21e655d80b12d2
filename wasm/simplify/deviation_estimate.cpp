#include "simplify/deviation_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "query/closest_point.h"
#include "simplify/cost/changed_triangles.h"

namespace limber {
namespace {

Vec3 positionOf(const std::array<float, 3>& p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

DeviationEstimate::DeviationEstimate(const CollapseMesh& mesh)
    : mesh_(mesh), isMoved_(mesh.vertexCount(), 0) {
  constexpr Witness none{{}, -1};
  witnesses_.assign(mesh.vertexCount(), {none, none, none});
}

// The distance of a point from the changed triangles; if that is at most `enough`, any distance up to
// `enough`.
double DeviationEstimate::distanceFromChanged(const Vec3& p, double enough) const {
  double least = std::numeric_limits<double>::infinity();
  const double squaredEnough = enough > 0 ? enough * enough : 0;
  for (const auto& [q, r] : changed_) {
    least = std::min(least, squaredLength(p - closestPosition(p, last_.target, q, r)));
    if (least <= squaredEnough) break;
  }
  return std::sqrt(least);
}

// The distance of the target from the triangles before the collapse; if that is at most `enough`, any
// distance up to `enough`.
double DeviationEstimate::distanceFromStars(const Collapse& step, double enough) const {
  double least = std::numeric_limits<double>::infinity();
  for (const uint32_t v : {step.kept, step.removed})
    for (const Corner corner : mesh_.star(v)) {
      const auto& [a, b, c] = mesh_.face(corner.triangle()).vertices;
      const Vec3 near = closestPosition(step.target, mesh_.position(a), mesh_.position(b), mesh_.position(c));
      least = std::min(least, squaredLength(step.target - near));
      if (least <= enough * enough) return enough;
    }
  return std::isfinite(least) ? std::sqrt(least) : 0;
}

// Keeps the witness if its bound is among the largest.
void DeviationEstimate::take(const Witness& witness) {
  Witness next = witness;
  for (Witness& slot : kept_)
    if (next.bound > slot.bound) std::swap(next, slot);
}

void DeviationEstimate::gather(uint32_t end) {
  const Vec3& position = mesh_.position(end);
  const double move = distanceFromChanged(position, 0);
  for (const Witness& witness : witnesses_[end]) {
    if (witness.bound < 0) break;
    // No witness is added whose bound is at most that of the last one stored.
    const double least = kept_.back().bound;
    if (witness.bound + move <= least) continue;
    const double distance = distanceFromChanged(positionOf(witness.position), least);
    take({witness.position, static_cast<float>(std::min(witness.bound + move, distance))});
  }
  if (!isMoved_[end])
    take({{static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)},
          static_cast<float>(move)});
}

double DeviationEstimate::of(const Collapse& step) {
  last_ = step;
  changed_.clear();
  forEachChangedTriangle(mesh_, step.edge, [&](const Vec3& q, const Vec3& r) { changed_.push_back({q, r}); });
  kept_.fill({{}, -1});
  estimate_ = 0;
  if (changed_.empty()) return estimate_;
  gather(step.kept);
  gather(step.removed);
  const double ofWitnesses = std::max(0.0, static_cast<double>(kept_[0].bound));
  estimate_ = std::max(distanceFromStars(step, ofWitnesses), ofWitnesses);
  return estimate_;
}

double DeviationEstimate::collapse(const Collapse& step) {
  if (last_.edge != step.edge || last_.kept != step.kept) of(step);
  const double estimate = estimate_;
  const Vec3 moved = step.target - mesh_.position(step.kept);
  if (moved.x != 0 || moved.y != 0 || moved.z != 0) isMoved_[step.kept] = 1;
  witnesses_[step.kept] = kept_;
  last_ = {kNone, kNone, kNone, {}};
  return estimate;
}

}  // namespace limber
