#include "query/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"
#include "mesh/corner.h"

namespace limber {

namespace {

constexpr double kSameWay = 0.25;        // cosine between normals
constexpr double kBetweenSheets = 0.01;  // of the diagonal
constexpr size_t kTrianglesPerRange = 4096;
constexpr double kFittingBox = 8;             // half the surface of a box over the area of the triangle in it
constexpr double kMaxPieces = 16;             // of a needle, in boxes that fit
constexpr uint64_t kCutsInAnyMesh = 1 << 18;  // larger meshes have a cut for each triangle
// The normal of a triangle that is flatter than this (height over length) is dominated by rounding, and its
// edges are as near as its inside.
constexpr double kMinHeight = 1e-8;
// Products of smaller squares lose digits, as doubles end at 1e-308.
constexpr double kMinSquare = 1e-280;
// The three coordinates of a foot point are computed separately, so their sum is off from 1 by about the
// rounding error of one of them, eps d / h at the distance d from a triangle of height h. A coordinate with
// that error moves the point by eps d L / h along the triangle, and taking an edge instead by at most h: the
// two are equal if the error is about the root of eps.
constexpr double kMaxRounding = 1e-8;

// Whether a triangle with the edges `first` and `second` and the given cross product has an inside.
bool hasInside(const Vec3& first, const Vec3& second, double squaredNormal) {
  const double square = std::max(squaredLength(first), squaredLength(second));
  return squaredNormal > std::max(kMinHeight * kMinHeight * square * square, kMinSquare);
}

// The parameter in [0, 1] of the point of the segment a + s (b - a) closest to p.
double closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double squares = squaredLength(b - a);
  return squares > 0 ? std::clamp(dot(p - a, b - a) / squares, 0.0, 1.0) : 0.0;
}

// Writes the barycentric coordinates of the point of a triangle closest to p: the foot of p on the plane if
// it lies inside the triangle and is accurate enough, else the closest point on the edges. Only edges beyond
// which the foot lies need to be tested, because the direction from the closest point of a convex set to p
// points outwards. Needles and points are allowed.
void closestBarycentric(const Vec3& p, const Vec3 (&corner)[3], double (&barycentric)[3]) {
  const Vec3 first = corner[1] - corner[0], second = corner[2] - corner[0];
  const Vec3 normal = cross(first, second);
  const double squaredNormal = squaredLength(normal);
  bool isSure = false;  // whether the edges to be tested are known
  if (hasInside(first, second, squaredNormal)) {
    double sum = 0, least = HUGE_VAL;
    for (int c = 0; c < 3; ++c) {
      const Vec3 &a = corner[(c + 1) % 3], &b = corner[(c + 2) % 3];
      barycentric[c] = dot(cross(b - a, p - a), normal) / squaredNormal;
      least = std::min(least, barycentric[c]);
      sum += barycentric[c];
    }
    isSure = std::abs(sum - 1) <= kMaxRounding;
    if (least >= 0 && isSure) return;
  }
  double best = HUGE_VAL;
  double found[3] = {1, 0, 0};
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3, opposite = (c + 2) % 3;
    if (isSure && barycentric[opposite] >= 0) continue;
    const double s = closestOnSegment(p, corner[c], corner[next]);
    const double distance = squaredLength(p - (corner[c] + (corner[next] - corner[c]) * s));
    if (distance >= best) continue;
    best = distance;
    found[c] = 1 - s;
    found[next] = s;
    found[opposite] = 0;
  }
  std::copy(found, found + 3, barycentric);
}

// A triangle that is cut across its longest edge, from a to b. `offset` leads to the third corner from the
// foot of its height, so that the triangle lies within the edge swept along it.
struct Needle {
  Vec3 a, b, corner, offset;
  double foot = 0;  // of the height, as a fraction of the edge

  Needle(const TriangleMesh& mesh, uint32_t t) {
    int longest = 0;
    double squares = -1;
    for (int c = 0; c < 3; ++c) {
      const double squared = squaredLength(mesh.corner(t, nextIndex(c)) - mesh.corner(t, previousIndex(c)));
      if (squared <= squares) continue;
      squares = squared;
      longest = c;
    }
    a = mesh.corner(t, nextIndex(longest));
    b = mesh.corner(t, previousIndex(longest));
    corner = mesh.corner(t, longest);
    foot = closestOnSegment(corner, a, b);
    offset = corner - at(foot);
  }
  Vec3 at(double fraction) const { return a * (1 - fraction) + b * fraction; }

  Bounds boxOfPiece(uint32_t piece, uint32_t count) const {
    const double from = static_cast<double>(piece) / count, to = static_cast<double>(piece + 1) / count;
    Bounds box{at(from), at(from)};
    for (const Vec3& p : {at(to), at(from) + offset, at(to) + offset}) box.include(p);
    if (from <= foot && foot <= to) box.include(corner);
    return box;
  }
};

// The number of pieces whose boxes are not much larger than the triangle: one for all but a needle oblique to
// the axes, whose box is mostly empty.
uint32_t piecesOf(const TriangleMesh& mesh, uint32_t t) {
  const Vec3 size = bounds(mesh, t).high - bounds(mesh, t).low;
  const double box = size.x * size.y + size.y * size.z + size.z * size.x;
  const double pieces = box / (kFittingBox * triangleArea(mesh, t));
  return pieces > 1 ? static_cast<uint32_t>(std::min(pieces, kMaxPieces)) : 1;
}

// Per triangle its first piece, and at the end the number of all pieces. If there would be too many, each
// needle is cut into fewer.
std::vector<uint32_t> firstPieces(const TriangleMesh& mesh) {
  std::vector<uint32_t> first(mesh.triangleCount() + size_t{1}, 0);
  uint64_t cuts = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    first[t + 1] = piecesOf(mesh, t);
    cuts += first[t + 1] - 1;
  }
  const uint64_t most = std::max<uint64_t>(mesh.triangleCount(), kCutsInAnyMesh);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const uint64_t own = first[t + 1] - 1;
    first[t + 1] = first[t] + 1 + static_cast<uint32_t>(cuts > most ? own * most / cuts : own);
  }
  return first;
}

}  // namespace

BoundingTree treeOver(const TriangleMesh& mesh) {
  const std::vector<uint32_t> first = firstPieces(mesh);
  std::vector<Bounds> boxes(first.back());
  std::vector<Vec3> centres(first.back());
  std::vector<uint32_t> triangleOfPiece(first.back());
  parallelFor(mesh.triangleCount(), kTrianglesPerRange, [&](size_t begin, size_t end) {
    for (auto t = static_cast<uint32_t>(begin); t < end; ++t) {
      const Needle needle(mesh, t);
      const uint32_t count = first[t + 1] - first[t];
      for (uint32_t i = 0; i < count; ++i) {
        const uint32_t piece = first[t] + i;
        boxes[piece] = count > 1 ? needle.boxOfPiece(i, count) : bounds(mesh, t);
        centres[piece] = count > 1 ? 0.5 * (boxes[piece].low + boxes[piece].high) : triangleCentre(mesh, t);
        triangleOfPiece[piece] = t;
      }
    }
  });
  return {boxes, centres, triangleOfPiece};
}

ClosestPoint closestOnTriangle(const TriangleMesh& mesh, uint32_t t, const Vec3& point) {
  const Vec3 corner[3] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  ClosestPoint found;
  found.triangle = t;
  closestBarycentric(point, corner, found.barycentric);
  for (int c = 0; c < 3; ++c) found.position += corner[c] * found.barycentric[c];
  found.distance = length(found.position - point);
  return found;
}

Vec3 closestPosition(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double area = squaredLength(n);
  // Barycentric weights of the foot point, times `area`.
  const double u = dot(cross(c - b, p - b), n), v = dot(cross(a - c, p - c), n), w = area - u - v;
  if (hasInside(b - a, c - a, area) && u >= 0 && v >= 0 && w >= 0) return (a * u + b * v + c * w) / area;

  Vec3 best = a;
  const std::array<std::array<const Vec3*, 2>, 3> edges{{{&a, &b}, {&b, &c}, {&c, &a}}};
  for (const auto& [from, to] : edges) {
    const Vec3 point = *from + (*to - *from) * closestOnSegment(p, *from, *to);
    if (squaredLength(p - point) < squaredLength(p - best)) best = point;
  }
  return best;
}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh) : mesh_(mesh), tree_(treeOver(mesh)) {}

template <class Counts>
ClosestPoint ClosestPointTree::search(const Vec3& point, const ClosestPoint& start, const Counts& counts,
                                      double enough) const {
  ClosestPoint best = start;
  const double squaredEnough = enough >= 0 ? enough * enough : -1;
  double bestSquared =
      start.triangle == kNone ? start.distance * start.distance : squaredLength(point - start.position);
  tree_.forEachWithin(point, bestSquared, [&](uint32_t t) {
    if (t == start.triangle || !counts(t)) return bestSquared;
    const Vec3 corner[3] = {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
    double barycentric[3];
    closestBarycentric(point, corner, barycentric);
    const Vec3 position =
        corner[0] * barycentric[0] + corner[1] * barycentric[1] + corner[2] * barycentric[2];
    const double squared = squaredLength(point - position);
    if (squared > bestSquared || (squared == bestSquared && t > best.triangle)) return bestSquared;
    bestSquared = squared;
    best.triangle = t;
    best.position = position;
    std::copy(barycentric, barycentric + 3, best.barycentric);
    return bestSquared <= squaredEnough ? -1 : bestSquared;
  });
  best.distance = std::sqrt(bestSquared);
  return best;
}

ClosestPoint ClosestPointTree::closest(const Vec3& point, uint32_t near) const {
  const ClosestPoint start =
      near == kNone ? ClosestPoint::within(HUGE_VAL) : closestOnTriangle(mesh_, near, point);
  return search(point, start, [](uint32_t) { return true; });
}

ClosestPoint ClosestPointTree::nearEnough(const Vec3& point, double enough, uint32_t near) const {
  const ClosestPoint start =
      near == kNone ? ClosestPoint::within(HUGE_VAL) : closestOnTriangle(mesh_, near, point);
  if (start.distance <= enough) return start;
  return search(point, start, [](uint32_t) { return true; }, enough);
}

ClosestPoint ClosestPointTree::nearestCorner(const Vec3& point, double enough, uint32_t near) const {
  const double squaredEnough = enough >= 0 ? enough * enough : -1;
  ClosestPoint best = ClosestPoint::within(HUGE_VAL);
  double bestSquared = HUGE_VAL;
  const auto take = [&](uint32_t t) {
    for (int c = 0; c < 3; ++c) {
      const double squared = squaredLength(point - mesh_.corner(t, c));
      if (squared >= bestSquared) continue;
      bestSquared = squared;
      best.triangle = t;
      best.position = mesh_.corner(t, c);
      for (int b = 0; b < 3; ++b) best.barycentric[b] = b == c;
    }
    return bestSquared <= squaredEnough ? -1 : bestSquared;
  };
  if (near == kNone || take(near) >= 0) tree_.forEachWithin(point, bestSquared, take);
  best.distance = std::sqrt(bestSquared);
  return best;
}

ClosestPoint ClosestPointTree::closestFacing(const Vec3& point, const Vec3& normal, uint32_t near) const {
  const auto looksThatWay = [&](uint32_t t) {
    return dot(normalized(areaNormal(mesh_, t)), normal) >= kSameWay;
  };
  const ClosestPoint any = closest(point, near);
  if (squaredLength(normal) == 0 || looksThatWay(any.triangle)) return any;
  const double slack = kBetweenSheets * tree_.box().diagonal();
  const ClosestPoint facing = search(point, ClosestPoint::within(any.distance + slack), looksThatWay);
  return facing.triangle != kNone ? facing : any;
}

}  // namespace limber
