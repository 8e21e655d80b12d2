#include "modes/lattice_slivers.h"

#include <algorithm>
#include <cmath>

#include "modes/lattice_rays.h"

namespace limber {

namespace {

constexpr int kRays = 24;  // along each side of the box

// Grows `box` by the part of a triangle within the cell.
void growByClipped(const Sliver& sliver, const Triangle& triangle, Bounds& box) {
  std::vector<Vec3> polygon;
  for (uint32_t v : triangle) polygon.push_back(sliver.points[v]);
  for (int plane = 0; plane < 6; ++plane) {
    const int axis = plane / 2;
    const double side = plane % 2 ? -1 : 1, at = sliver.place[axis] + plane % 2;
    std::vector<Vec3> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double before = side * (p[axis] - at), after = side * (q[axis] - at);
      if (before >= 0) kept.push_back(p);
      if ((before < 0) != (after < 0)) kept.push_back(p + (q - p) * (before / (before - after)));
    }
    polygon = kept;
  }
  for (const Vec3& p : polygon)
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
}

// The rays of one direction across the box.
class Rays {
 public:
  Rays(const Sliver& sliver, const Bounds& box, int axis)
      : sliver_(sliver),
        box_(box),
        axis_(axis),
        u_((axis + 1) % 3),
        v_((axis + 2) % 3),
        hits_(kRays * kRays) {
    for (uint32_t t : sliver.around) cast(sliver.triangles[t]);
  }

  CellMeasure measure() {
    CellMeasure measure = {};
    for (int a = 0; a < kRays; ++a)
      for (int b = 0; b < kRays; ++b) addRay(a, b, measure);
    return measure;
  }

 private:
  double place(int axis, double ray) const {
    return box_.low[axis] + (box_.high[axis] - box_.low[axis]) * ray / kRays;
  }

  // The rays that may meet a triangle, along one axis.
  std::array<int, 2> range(const Triangle& triangle, int axis) const {
    const double width = box_.high[axis] - box_.low[axis];
    if (!(width > 0)) return {0, -1};
    const auto [low, high] =
        std::minmax({sliver_.points[triangle[0]][axis], sliver_.points[triangle[1]][axis],
                     sliver_.points[triangle[2]][axis]});
    const auto number = [&](double x) { return std::clamp((x - box_.low[axis]) / width, -1.0, 2.0) * kRays; };
    return {std::max(0, static_cast<int>(std::floor(number(low))) - 1),
            std::min(kRays - 1, static_cast<int>(std::ceil(number(high))))};
  }

  void cast(const Triangle& triangle) {
    const auto [firstU, lastU] = range(triangle, u_);
    const auto [firstV, lastV] = range(triangle, v_);
    for (int a = firstU; a <= lastU; ++a)
      for (int b = firstV; b <= lastV; ++b) {
        const auto hit = hitTriangle(sliver_.points, triangle, axis_, place(u_, a + 0.5), place(v_, b + 0.5));
        if (hit) hits_[a * kRays + b].push_back(*hit);
      }
  }

  // What lies between an entry and an exit is inside.
  void addRay(int a, int b, CellMeasure& measure) {
    auto& hits = hits_[a * kRays + b];
    std::stable_sort(hits.begin(), hits.end(),
                     [](const LineHit& p, const LineHit& q) { return p.depth < q.depth; });
    int winding = 0;
    double before = 0;
    for (const LineHit& hit : hits) {
      const double depth = std::clamp(hit.depth - sliver_.place[axis_], 0.0, 1.0);
      if (winding > 0) addStretch(a, b, {before, depth}, measure);
      winding = std::max(0, winding + (hit.isEntry ? sliver_.sign : -sliver_.sign));
      before = depth;
    }
  }

  static std::array<double, 3> integrals(double from, double to) {
    const auto begin = lagrangeIntegrals(from), end = lagrangeIntegrals(to);
    return {end[0] - begin[0], end[1] - begin[1], end[2] - begin[2]};
  }

  void addStretch(int a, int b, std::array<double, 2> along, CellMeasure& measure) const {
    constexpr int step[3] = {1, 3, 9};
    const int pu = sliver_.place[u_], pv = sliver_.place[v_];
    const auto l = integrals(along[0], along[1]);
    const auto lu = integrals(place(u_, a) - pu, place(u_, a + 1) - pu);
    const auto lv = integrals(place(v_, b) - pv, place(v_, b + 1) - pv);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          measure[step[axis_] * k + step[u_] * i + step[v_] * j] += l[k] * lu[i] * lv[j];
  }

  const Sliver& sliver_;
  const Bounds& box_;
  int axis_, u_, v_;
  std::vector<std::vector<LineHit>> hits_;  // by ray
};

}  // namespace

CellMeasure measureSliver(const Sliver& sliver) {
  Bounds box{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (uint32_t t : sliver.around) growByClipped(sliver, sliver.triangles[t], box);
  CellMeasure best = {};
  if (!(box.low.x <= box.high.x)) return best;
  for (int axis = 0; axis < 3; ++axis) {
    const CellMeasure measure = Rays(sliver, box, axis).measure();
    if (filledFraction(measure) > filledFraction(best)) best = measure;
  }
  return best;
}

}  // namespace limber
