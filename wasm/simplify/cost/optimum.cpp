#include "simplify/cost/optimum.h"

#include <algorithm>

namespace limber {
namespace {

constexpr double kFrameDiagonal = 300;
// How far from the middle of an edge its optimum may lie, in lengths of the edge. Farther ones come from
// nearly parallel planes and create spikes; a smaller bound would cut off sharp corners.
constexpr double kLargestOffset = 2;

}  // namespace

OptimumFinder::OptimumFinder(const CollapseMesh& mesh, const SimplifyConstraints& constraints,
                             double lengthWeight)
    : mesh_(mesh),
      lengthScale_(kFrameDiagonal / mesh.diagonal()),
      lengthWeight_(kTieBreak + lengthWeight),
      attributes_(mesh, constraints) {
  lengthScale_ *= lengthScale_;
}

double OptimumFinder::squaredLengthOf(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  return lengthScale_ * squaredLength(mesh_.position(b) - mesh_.position(a));
}

// The point of least error of one edge or of two, rounded as it will be stored.
template <class Real>
struct OptimumFinder::Minimum {
  Point<Real> position;
  Real error;   // E_QEM
  Real excess;  // positive if the position lies too far away
};

template <class Real>
OptimumFinder::Minimum<Real> OptimumFinder::minimumOf(const QuadricOf<Real>& sum, const Point<Real>& p,
                                                      const Point<Real>& q) const {
  const Point<Real> edge = q - p, middle = (p + q) * 0.5;
  const Point<Real> least = minimize(sum, middle), offset = least - middle;
  const Point<Real> position = mesh_.rounded(least);
  const Real square = dot(edge, edge);
  return {position, lengthScale_ * (normalizedError(sum, position) + lengthWeight_ * square),
          dot(offset, offset) - kLargestOffset * kLargestOffset * square};
}

Optimum OptimumFinder::find(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Vec3 &p = mesh_.position(a), &q = mesh_.position(b);
  const Quadric sum = sumOf(edge);
  const auto at = [&](const Vec3& position) {
    const double error = normalizedError(sum, asPoint(position)) + lengthWeight_ * squaredLength(q - p);
    return Optimum{position, lengthScale_ * error};
  };
  if (const uint32_t fixed = mesh_.fixedEnd(edge); fixed != kNone)
    return at(mesh_.stored(mesh_.position(fixed)));
  const auto minimum = minimumOf(sum, asPoint(p), asPoint(q));
  if (!(minimum.excess > 0)) return {asVec3(minimum.position), minimum.error};
  const Vec3 middle = asVec3(mesh_.rounded(asPoint((p + q) * 0.5)));
  const Optimum choices[] = {at(middle), at(mesh_.stored(p)), at(mesh_.stored(q))};
  return *std::ranges::min_element(choices, {}, &Optimum::error);
}

// Bit-identical to `find` for each, in less time.
std::array<Optimum, 2> OptimumFinder::findTwo(const Input& e, const Input& f) const {
  if (!e.isFree || !f.isFree) return {find(e.edge), find(f.edge)};
  const auto minimum = minimumOf(asPair(e.sum, f.sum), asPair(e.p, f.p), asPair(e.q, f.q));
  const auto optimum = [&](uint32_t edge, int i) {
    return minimum.excess[i] > 0 ? find(edge) : Optimum{lane(minimum.position, i), minimum.error[i]};
  };
  return {optimum(e.edge, 0), optimum(f.edge, 1)};
}

}  // namespace limber
