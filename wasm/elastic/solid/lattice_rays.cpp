#include "elastic/solid/lattice_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace limber {

namespace {

constexpr uint32_t kCheckInterval = 4096;  // triangles between two checks for cancellation

// The side of an edge on which a line passes, as seen along the line.
struct EdgeSide {
  double area;    // twice that of the triangle (from, to, line)
  bool isInside;  // the line passes to the left
};

// Computed with the lower vertex first, so that both triangles of an edge agree. A line through the edge
// counts as on one side.
EdgeSide sideOf(const std::vector<Vec3>& points, uint32_t from, uint32_t to, const AxisLine& line) {
  const auto [axis, u, v] = line;
  const int axisU = (axis + 1) % 3, axisV = (axis + 2) % 3;
  const bool isReversed = from > to;
  const Vec3 &a = points[isReversed ? to : from], &b = points[isReversed ? from : to];
  const double area = (a[axisU] - u) * (b[axisV] - v) - (a[axisV] - v) * (b[axisU] - u);
  return isReversed ? EdgeSide{-area, area < 0} : EdgeSide{area, area >= 0};
}

class Caster {
 public:
  Caster(const LatticeSurface& surface, RayFamily& family)
      : points_(surface.points), family_(family), u_((family.axis + 1) % 3), v_((family.axis + 2) % 3) {
    raysAlongU_ = surface.grid.count[u_] * kSamples;
    raysAlongV_ = surface.grid.count[v_] * kSamples;
  }

  void cast(const Triangle& triangle, uint32_t t) {
    const auto [firstU, lastU] = range(triangle, u_, raysAlongU_);
    const auto [firstV, lastV] = range(triangle, v_, raysAlongV_);
    for (int a = firstU; a <= lastU; ++a)
      for (int b = firstV; b <= lastV; ++b) {
        const double u = a / kSamples + samplePosition(u_, a % kSamples);
        const double v = b / kSamples + samplePosition(v_, b % kSamples);
        const auto hit = hitTriangle(points_, triangle, {family_.axis, u, v});
        if (hit)
          family_.crossings.push_back(
              {static_cast<uint32_t>(a * raysAlongV_ + b), t, hit->depth, hit->isEntry});
      }
  }

 private:
  // The first and the last ray along one axis that may meet the triangle.
  std::array<int, 2> range(const Triangle& triangle, int axis, int count) const {
    const auto [low, high] =
        std::minmax({points_[triangle[0]][axis], points_[triangle[1]][axis], points_[triangle[2]][axis]});
    const double first = samplePosition(axis, 0);
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

// Adds the intervals of one ray, which has the crossings [begin, end).
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

std::optional<LineHit> hitTriangle(const std::vector<Vec3>& points, const Triangle& triangle,
                                   const AxisLine& line) {
  std::array<EdgeSide, 3> sides;
  for (int c = 0; c < 3; ++c) sides[c] = sideOf(points, triangle[(c + 1) % 3], triangle[(c + 2) % 3], line);
  if (sides[0].isInside != sides[1].isInside || sides[1].isInside != sides[2].isInside) return {};
  double depth = 0, total = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (int c = 0; c < 3; ++c) {
    const double corner = points[triangle[c]][line.axis];
    depth += sides[c].area * corner;
    total += sides[c].area;
    low = std::min(low, corner);
    high = std::max(high, corner);
  }
  depth = total != 0 ? std::clamp(depth / total, low, high) : low;
  // If a triangle winds counter-clockwise around the line, its normal points along the line, so the line
  // exits there.
  return LineHit{depth, !sides[0].isInside};
}

RayFamily castRays(const LatticeSurface& surface, int axis, Job& job) {
  RayFamily family;
  family.axis = axis;
  Caster caster(surface, family);
  for (uint32_t t = 0; t < surface.triangles.size(); ++t) {
    if (t % kCheckInterval == 0) job.check();
    caster.cast(surface.triangles[t], t);
  }
  sortCrossings(family);
  job.check();
  const auto count = static_cast<uint32_t>(family.crossings.size());
  for (uint32_t begin = 0, end; begin < count; begin = end) {
    for (end = begin; end < count && family.crossings[end].ray == family.crossings[begin].ray;) ++end;
    addIntervals(family, begin, end, surface.sign);
  }
  return family;
}

}  // namespace limber
