#include "elastic/solid/lattice_slivers.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "elastic/solid/lattice_rays.h"

namespace limber {

namespace {

constexpr int kRays = 24;  // along each side of the bounding box

// The part of a triangle within the cell.
std::vector<Vec3> clipped(const Sliver& sliver, const Triangle& triangle) {
  std::vector<Vec3> polygon, kept;
  for (uint32_t v : triangle) polygon.push_back(sliver.surface.points[v]);
  for (int plane = 0; plane < 6; ++plane) {
    const int axis = plane / 2;
    const double side = plane % 2 ? -1 : 1, at = sliver.position[axis] + plane % 2;
    kept.clear();
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double before = side * (p[axis] - at), after = side * (q[axis] - at);
      if (before >= 0) kept.push_back(p);
      if ((before < 0) != (after < 0)) kept.push_back(p + (q - p) * (before / (before - after)));
    }
    std::swap(polygon, kept);
  }
  return polygon;
}

Bounds boxOf(const std::vector<std::vector<Vec3>>& polygons) {
  Bounds box{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (const auto& polygon : polygons)
    for (const Vec3& p : polygon)
      for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], p[axis]);
        box.high[axis] = std::max(box.high[axis], p[axis]);
      }
  return box;
}

// Whether the polygons face away from each other. By the divergence theorem the sum along an axis is six
// times the volume between them, if the piece does not end on a cell face across that axis. `byOneAxis`: one
// positive sum suffices; otherwise the total of the three is used.
bool isFacingOut(const std::vector<std::vector<Vec3>>& polygons, const Vec3& centre, int sign,
                 bool byOneAxis) {
  Vec3 volume;
  for (const auto& polygon : polygons)
    for (size_t i = 2; i < polygon.size(); ++i) {
      const Vec3 &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
      const Vec3 normal = cross(b - a, c - a), offset = a + b + c - 3 * centre;
      for (int axis = 0; axis < 3; ++axis) volume[axis] += sign * offset[axis] * normal[axis];
    }
  return byOneAxis ? std::max({volume.x, volume.y, volume.z}) > 0 : volume.x + volume.y + volume.z > 0;
}

// The rays of one direction across the bounding box.
class Rays {
 public:
  Rays(const Sliver& sliver, const Bounds& box, int axis)
      : sliver_(sliver), box_(box), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
    for (uint32_t t : sliver.around) cast(sliver.surface.triangles[t]);
    std::stable_sort(hits_.begin(), hits_.end(), [](const RayHit& p, const RayHit& q) {
      return p.ray != q.ray ? p.ray < q.ray : p.hit.depth < q.hit.depth;
    });
  }

  CellMeasure measure() const {
    CellMeasure measure = {};
    for (auto first = hits_.begin(); first != hits_.end();) {
      const auto last =
          std::find_if(first, hits_.end(), [&](const RayHit& hit) { return hit.ray != first->ray; });
      addRay({first, last}, measure);
      first = last;
    }
    return measure;
  }

 private:
  struct RayHit {
    int ray;  // kRays * a + b of the ray a along u and b along v
    LineHit hit;
  };

  double position(int axis, double ray) const {
    return box_.low[axis] + (box_.high[axis] - box_.low[axis]) * ray / kRays;
  }

  // The first and the last ray along one axis that may meet a triangle.
  std::array<int, 2> range(const Triangle& triangle, int axis) const {
    const double width = box_.high[axis] - box_.low[axis];
    if (!(width > 0)) return {0, -1};
    const auto [low, high] =
        std::minmax({sliver_.surface.points[triangle[0]][axis], sliver_.surface.points[triangle[1]][axis],
                     sliver_.surface.points[triangle[2]][axis]});
    const auto number = [&](double x) { return std::clamp((x - box_.low[axis]) / width, -1.0, 2.0) * kRays; };
    return {std::max(0, static_cast<int>(std::floor(number(low))) - 1),
            std::min(kRays - 1, static_cast<int>(std::ceil(number(high))))};
  }

  void cast(const Triangle& triangle) {
    const auto [firstU, lastU] = range(triangle, u_);
    const auto [firstV, lastV] = range(triangle, v_);
    for (int a = firstU; a <= lastU; ++a)
      for (int b = firstV; b <= lastV; ++b) {
        const auto hit = hitTriangle(sliver_.surface.points, triangle,
                                     {axis_, position(u_, a + 0.5), position(v_, b + 0.5)});
        if (!hit) continue;
        const double depth = hit->depth - sliver_.position[axis_];
        if (depth >= 0 && depth <= 1) hits_.push_back({a * kRays + b, {depth, hit->isEntry}});
      }
  }

  // A ray that exits before it enters was already inside at the cell face. A ray that enters and does not
  // exit stays inside beyond the cell. `hits`: all hits of one ray, in order.
  void addRay(std::span<const RayHit> hits, CellMeasure& measure) const {
    const int a = hits.front().ray / kRays, b = hits.front().ray % kRays;
    const auto step = [&](const RayHit& at) {
      return at.hit.isEntry ? sliver_.surface.sign : -sliver_.surface.sign;
    };
    int winding = 0, lowest = 0;
    for (const RayHit& at : hits) lowest = std::min(lowest, winding += step(at));
    winding = -lowest;
    double before = 0;
    for (const RayHit& at : hits) {
      if (winding > 0) addStretch(a, b, {before, at.hit.depth}, measure);
      winding += step(at);
      before = at.hit.depth;
    }
    if (winding > 0) addStretch(a, b, {before, 1}, measure);
  }

  static std::array<double, 3> integrals(double from, double to) {
    const auto begin = lagrangeIntegrals(from), end = lagrangeIntegrals(to);
    return {end[0] - begin[0], end[1] - begin[1], end[2] - begin[2]};
  }

  void addStretch(int a, int b, std::array<double, 2> along, CellMeasure& measure) const {
    constexpr int step[3] = {1, 3, 9};
    const int pu = sliver_.position[u_], pv = sliver_.position[v_];
    const auto l = integrals(along[0], along[1]);
    const auto lu = integrals(position(u_, a) - pu, position(u_, a + 1) - pu);
    const auto lv = integrals(position(v_, b) - pv, position(v_, b + 1) - pv);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          measure[step[axis_] * k + step[u_] * i + step[v_] * j] += l[k] * lu[i] * lv[j];
  }

  const Sliver& sliver_;
  const Bounds& box_;
  int axis_, u_, v_;
  std::vector<RayHit> hits_;  // by rays, on each by depth
};

}  // namespace

CellMeasure measureSliver(const Sliver& sliver) {
  std::vector<std::vector<Vec3>> polygons;
  for (uint32_t t : sliver.around) polygons.push_back(clipped(sliver, sliver.surface.triangles[t]));
  const Bounds box = boxOf(polygons);
  CellMeasure best = {};
  if (!(box.low.x <= box.high.x) ||
      !isFacingOut(polygons, (box.low + box.high) / 2, sliver.surface.sign, sliver.isMet))
    return best;
  for (int axis = 0; axis < 3; ++axis) {
    const CellMeasure measure = Rays(sliver, box, axis).measure();
    if (filledFraction(measure) > filledFraction(best)) best = measure;
  }
  return best;
}

}  // namespace limber
