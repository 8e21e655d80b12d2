#include "elastic/solid/lattice_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace limber {

namespace {

// On which side of an edge a point lies, seen along the line.
struct Side {
  double area;    // twice that of (from, to, point)
  bool isInside;  // the point lies to the left
};

// Always taken with the lower vertex first, and a point on the edge counts to one side.
Side sideOf(const std::vector<Vec3>& points, uint32_t from, uint32_t to, int axis, double u, double v) {
  const int axisU = (axis + 1) % 3, axisV = (axis + 2) % 3;
  const bool isTurned = from > to;
  const Vec3 &a = points[isTurned ? to : from], &b = points[isTurned ? from : to];
  const double area = (a[axisU] - u) * (b[axisV] - v) - (a[axisV] - v) * (b[axisU] - u);
  return isTurned ? Side{-area, area < 0} : Side{area, area >= 0};
}

class Caster {
 public:
  Caster(const std::vector<Vec3>& points, const LatticeGrid& grid, RayFamily& family)
      : points_(points), family_(family), u_((family.axis + 1) % 3), v_((family.axis + 2) % 3) {
    raysAlongU_ = grid.count[u_] * kSamples;
    raysAlongV_ = grid.count[v_] * kSamples;
  }

  void cast(const Triangle& triangle, uint32_t t) {
    const auto [firstU, lastU] = range(triangle, u_, raysAlongU_);
    const auto [firstV, lastV] = range(triangle, v_, raysAlongV_);
    for (int a = firstU; a <= lastU; ++a)
      for (int b = firstV; b <= lastV; ++b) {
        const double u = a / kSamples + samplePlace(u_, a % kSamples);
        const double v = b / kSamples + samplePlace(v_, b % kSamples);
        const auto hit = hitTriangle(points_, triangle, family_.axis, u, v);
        if (hit)
          family_.crossings.push_back(
              {static_cast<uint32_t>(a * raysAlongV_ + b), t, hit->depth, hit->isEntry});
      }
  }

 private:
  // The numbers of the rays that may meet the triangle, along one axis.
  std::array<int, 2> range(const Triangle& triangle, int axis, int count) const {
    const auto [low, high] =
        std::minmax({points_[triangle[0]][axis], points_[triangle[1]][axis], points_[triangle[2]][axis]});
    const double first = samplePlace(axis, 0);
    return {std::max(0, static_cast<int>(std::floor((low - first) * kSamples))),
            std::min(count - 1, static_cast<int>(std::ceil((high - first) * kSamples)))};
  }

  const std::vector<Vec3>& points_;
  RayFamily& family_;
  int u_, v_, raysAlongU_, raysAlongV_;
};

void sortCrossings(RayFamily& family) {
  std::sort(family.crossings.begin(), family.crossings.end(), [](const auto& a, const auto& b) {
    return std::tie(a.ray, a.depth, a.triangle) < std::tie(b.ray, b.depth, b.triangle);
  });
}

// The intervals of one ray, whose crossings are [begin, end).
void addIntervals(RayFamily& family, uint32_t begin, uint32_t end, int sign) {
  const size_t before = family.intervals.size();
  int winding = 0;
  uint32_t first = begin;
  for (uint32_t c = begin; c < end; ++c) {
    const int next = winding + (family.crossings[c].isEntry ? sign : -sign);
    if (winding <= 0 && next > 0) first = c;
    if (winding > 0 && next <= 0) family.intervals.push_back({first, c});
    winding = next;
  }
  if (winding != 0) family.intervals.resize(before);
}

}  // namespace

std::optional<LineHit> hitTriangle(const std::vector<Vec3>& points, const Triangle& triangle, int axis,
                                   double u, double v) {
  std::array<Side, 3> sides;
  for (int c = 0; c < 3; ++c)
    sides[c] = sideOf(points, triangle[(c + 1) % 3], triangle[(c + 2) % 3], axis, u, v);
  if (sides[0].isInside != sides[1].isInside || sides[1].isInside != sides[2].isInside) return {};
  double depth = 0, total = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (int c = 0; c < 3; ++c) {
    const double corner = points[triangle[c]][axis];
    depth += sides[c].area * corner;
    total += sides[c].area;
    low = std::min(low, corner);
    high = std::max(high, corner);
  }
  depth = total != 0 ? std::clamp(depth / total, low, high) : low;
  // A triangle that turns left around the line looks along it: there the line leaves.
  return LineHit{depth, !sides[0].isInside};
}

RayFamily castRays(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                   const LatticeGrid& grid, int axis, int sign, Job& job) {
  RayFamily family;
  family.axis = axis;
  Caster caster(points, grid, family);
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    if (t % 4096 == 0) job.check();
    caster.cast(triangles[t], t);
  }
  sortCrossings(family);
  job.check();
  const auto count = static_cast<uint32_t>(family.crossings.size());
  for (uint32_t begin = 0, end; begin < count; begin = end) {
    for (end = begin; end < count && family.crossings[end].ray == family.crossings[begin].ray;) ++end;
    addIntervals(family, begin, end, sign);
  }
  return family;
}

}  // namespace limber
