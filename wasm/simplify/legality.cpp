#include "simplify/legality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/real_pair.h"

namespace limber {
namespace {

// A face may rotate by up to 78 degrees in one collapse (cosine of the angle between its normals). Smaller
// cosines allow more collapses and more folds.
constexpr double kSmallestCosine = 0.2;
// A face whose height is a smaller fraction of its longest edge has practically no area. No collapse may
// create such a face, but existing ones may stay.
constexpr double kSmallestHeight = 1e-6;
// Below this fraction of the longest edge the height is float32 noise, so the face has no orientation that
// could flip.
constexpr double kNoise = 1e-8;

// The square of twice the area over the squared longest edge, that is, of the height over that edge.
double squaredFlatness(const Vec3& areaNormal, const Vec3& p, const Vec3& q, const Vec3& r) {
  const double longest = std::max({squaredLength(q - p), squaredLength(r - q), squaredLength(p - r)});
  return squaredLength(areaNormal) / (longest * longest);
}

// Whether face (p, q, r) flips or loses its area when p moves to `target`.
bool isSpoilt(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& target) {
  const Vec3 side = r - q;
  const Vec3 before = cross(side, p - q), after = cross(side, target - q);
  const double cosine = dot(before, after);
  const double lengths = squaredLength(before) * squaredLength(after);
  const bool flips = cosine <= 0 || cosine * cosine < kSmallestCosine * kSmallestCosine * lengths;
  // No edge is longer than the other two together, so this bound usually shows at once that the height
  // suffices.
  const double square = 2 * (squaredLength(side) + squaredLength(target - q));
  if (!flips && squaredLength(after) > 4 * kSmallestHeight * kSmallestHeight * square * square) return false;
  const double flatness = squaredFlatness(after, target, q, r);
  if (!flips && flatness > kSmallestHeight * kSmallestHeight) return false;
  const double flatnessBefore = squaredFlatness(before, p, q, r);
  if (!(flatnessBefore > kNoise * kNoise)) return false;
  return flips || !(flatness >= flatnessBefore);
}

// Whether the quick bound of `isSpoilt` shows that neither of two faces (p, q, r) is spoilt.
bool areSafe(const Point<RealPair>& p, const Point<RealPair>& q, const Point<RealPair>& r,
             const Point<RealPair>& target) {
  const Point<RealPair> side = r - q, way = target - q;
  const Point<RealPair> before = cross(side, p - q), after = cross(side, way);
  const RealPair cosine = dot(before, after);
  const RealPair lengths = dot(before, before) * dot(after, after);
  const auto flips = (cosine <= 0) | (cosine * cosine < kSmallestCosine * kSmallestCosine * lengths);
  const RealPair square = 2 * (dot(side, side) + dot(way, way));
  const auto safe = ~flips & (dot(after, after) > 4 * kSmallestHeight * kSmallestHeight * square * square);
  return (safe[0] & safe[1]) != 0;
}

// The cosine of the smallest angle of triangle (p, q, r); 1 if an edge has no length.
double largestCosine(const Vec3& p, const Vec3& q, const Vec3& r) {
  const auto cosineAt = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    const double lengths = squaredLength(b - a) * squaredLength(c - a);
    return lengths > 0 ? dot(b - a, c - a) / std::sqrt(lengths) : 1;
  };
  return std::max({cosineAt(p, q, r), cosineAt(q, r, p), cosineAt(r, p, q)});
}

}  // namespace

Legality::Legality(CollapseMesh& mesh, const SimplifyOptions& options)
    : mesh_(mesh),
      pinnedSets_(options.constraints.pinnedSets),
      largestCosine_(std::cos(options.minAngle * std::numbers::pi / 180)) {}

Verdict Legality::check(const Collapse& step) {
  if (const Verdict verdict = permanentVerdict(step.edge); verdict != Verdict::Legal) return verdict;
  if (!keepsTopology(step)) return Verdict::Topology;
  if (spoilsAnyFace(step)) return Verdict::Flip;
  if (largestCosine_ < 1 && spoilsAngles(step)) return Verdict::Angle;
  return Verdict::Legal;
}

// Whether a member of a pinned set would be removed by a vertex that is in other sets, or a vertex in no set
// by a member that moves.
bool Legality::mixesPinnedSets(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  if (pinnedSets_[a] == pinnedSets_[b]) return false;
  const uint32_t kept = mesh_.fixedEnd(edge);
  return kept == kNone || pinnedSets_[kept == a ? b : a] != 0;
}

// The link condition: the links of the two ends meet in the link of the edge and nowhere else, where each
// border is closed by a virtual vertex (Dey et al. 1999). Then the collapse is a homeomorphism, so
// components, loops and genus do not change. In terms of vertices, the ends have no common neighbours except
// the third vertices of the edge's triangles. In terms of edges there are two cases left:
// - a tetrahedron, whose opposite edge lies in both links;
// - a lone triangle, whose other two edges are borders, so that the edge from the third vertex to the virtual
//   one lies in both links.
// (A border loop of three edges is caught as a common neighbour, interior edges between borders by
// `permanentVerdict`.) Feature edges are closed by the same virtual vertex, so that surface and feature edges
// together keep their topology: an edge with both ends on feature edges must itself be a feature edge, and no
// triangle with three feature edges may vanish.
bool Legality::keepsTopology(const Collapse& step) {
  const auto triangles = static_cast<uint32_t>(mesh_.trianglesOnEdge(step.edge));
  const auto starKept = mesh_.star(step.kept), starRemoved = mesh_.star(step.removed);
  if (triangles == 1) {
    if (starKept.size() == 1 && starRemoved.size() == 1) return false;
  } else {
    const bool inside = !mesh_.role(step.kept).onBorder && !mesh_.role(step.removed).onBorder;
    if (inside && starKept.size() == 3 && starRemoved.size() == 3) return false;
  }
  if (joinsFeatures(step)) return false;
  return mesh_.changeOf(step).commonNeighbours == triangles;
}

// Whether a triangle would vanish whose three edges are all feature edges.
bool Legality::joinsFeatures(const Collapse& step) const {
  if (!mesh_.role(step.kept).onFeature || !mesh_.role(step.removed).onFeature) return false;
  for (const Corner corner : mesh_.star(step.removed)) {
    const auto& edges = mesh_.face(corner.triangle()).edges;
    const int features = mesh_.isFeature(edges[0]) + mesh_.isFeature(edges[1]) + mesh_.isFeature(edges[2]);
    const bool vanishes = edges[0] == step.edge || edges[1] == step.edge || edges[2] == step.edge;
    if (vanishes && features == 3) return true;
  }
  return false;
}

// Whether the smallest angle of the changed triangles after the collapse is below `minAngle` and no larger
// than the smallest angle of all triangles of both ends before it.
bool Legality::spoilsAngles(const Collapse& step) const {
  double before = -1, after = -1;
  for (const uint32_t v : {step.kept, step.removed})
    for (const Corner corner : mesh_.star(v)) {
      const CollapseMesh::Face& face = mesh_.face(corner.triangle());
      const int next = nextIndex(corner.index()), previous = previousIndex(corner.index());
      const Vec3 &q = mesh_.position(face.vertices[next]), &r = mesh_.position(face.vertices[previous]);
      before = std::max(before, largestCosine(mesh_.position(v), q, r));
      const bool vanishes = face.edges[next] == step.edge || face.edges[previous] == step.edge;
      if (!vanishes) after = std::max(after, largestCosine(step.target, q, r));
    }
  return after > largestCosine_ && after >= before;
}

// Checks two faces at a time; the last one may be checked twice.
bool Legality::spoilsAnyFace(const Collapse& step) {
  const CollapseMesh::Change& change = mesh_.changeOf(step);
  const Vec3 &kept = mesh_.position(step.kept), &removed = mesh_.position(step.removed);
  const auto faceAt = [&](size_t i) {
    const Corner corner = change.corners[i];
    const Triangle& vertices = mesh_.face(corner.triangle()).vertices;
    return std::array{i < change.ofKept ? &kept : &removed,
                      &mesh_.position(vertices[nextIndex(corner.index())]),
                      &mesh_.position(vertices[previousIndex(corner.index())])};
  };
  const Point<RealPair> target = asPair(step.target, step.target);
  for (size_t i = 0; i < change.count; i += 2) {
    const auto [p, q, r] = faceAt(i);
    const auto [s, t, u] = faceAt(std::min(i + 1, change.count - 1));
    if (areSafe(asPair(*p, *s), asPair(*q, *t), asPair(*r, *u), target)) continue;
    if (isSpoilt(*p, *q, *r, step.target) || isSpoilt(*s, *t, *u, step.target)) return true;
  }
  return false;
}

}  // namespace limber
