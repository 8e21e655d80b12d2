#include "elastic/solid/lattice_fragments.h"

#include <algorithm>
#include <array>

namespace limber {

namespace {

constexpr size_t kCheckInterval = 4096;  // triangles between two checks for cancellation

// A convex polygon. A triangle cut by six planes has at most nine corners.
struct Polygon {
  std::array<Vec3, 12> corners;
  int size = 0;
  void add(const Vec3& p) { corners[size++] = p; }
};

// Returns the part of the polygon below the plane; the argument becomes the rest. Both get the same cut
// points, so that they match to the last bit.
Polygon cutBelow(Polygon& polygon, int axis, double plane) {
  Polygon below, above;
  for (int i = 0; i < polygon.size; ++i) {
    const Vec3 &p = polygon.corners[i], &q = polygon.corners[(i + 1) % polygon.size];
    const bool isBelow = p[axis] < plane, isNextBelow = q[axis] < plane;
    (isBelow ? below : above).add(p);
    if (isBelow == isNextBelow) continue;
    Vec3 cut = p + (q - p) * ((plane - p[axis]) / (q[axis] - p[axis]));
    cut[axis] = plane;
    below.add(cut);
    above.add(cut);
  }
  polygon = above;
  return below;
}

// The first and the last cell of a polygon along an axis.
std::array<int, 2> cellsAlong(const Polygon& polygon, int axis, const LatticeGrid& grid) {
  double low = polygon.corners[0][axis], high = low;
  for (int i = 1; i < polygon.size; ++i) {
    low = std::min(low, polygon.corners[i][axis]);
    high = std::max(high, polygon.corners[i][axis]);
  }
  return {grid.along(axis, low), grid.along(axis, high)};
}

class Cutter {
 public:
  Cutter(const LatticeGrid& grid, Fragments& fragments) : grid_(grid), fragments_(fragments) {}

  // Cuts along `axis` and all later axes. `position` has the cells along the previous axes.
  void cut(Polygon polygon, int axis, std::array<int, 3> position) {
    if (axis == 3) {
      fragments_.cell.push_back(grid_.cellAt(position[0], position[1], position[2]));
      return;
    }
    const auto [low, high] = cellsAlong(polygon, axis, grid_);
    for (position[axis] = low; position[axis] < high; ++position[axis]) {
      const Polygon below = cutBelow(polygon, axis, position[axis] + 1.0);
      if (below.size > 0) cut(below, axis + 1, position);
    }
    if (polygon.size > 0) cut(polygon, axis + 1, position);
  }

 private:
  const LatticeGrid& grid_;
  Fragments& fragments_;
};

}  // namespace

uint32_t Fragments::find(uint32_t triangle, uint32_t wanted) const {
  const auto first = cell.begin() + start[triangle], last = cell.begin() + start[triangle + 1];
  const auto found = std::lower_bound(first, last, wanted);
  return found != last && *found == wanted ? static_cast<uint32_t>(found - cell.begin()) : kNone;
}

Fragments cutIntoFragments(const LatticeSurface& surface, Job& job) {
  Fragments fragments;
  Cutter cutter(surface.grid, fragments);
  fragments.start.push_back(0);
  for (size_t t = 0; t < surface.triangles.size(); ++t) {
    if (t % kCheckInterval == 0) job.check();
    Polygon polygon;
    for (uint32_t v : surface.triangles[t]) polygon.add(surface.points[v]);
    cutter.cut(polygon, 0, {0, 0, 0});
    fragments.start.push_back(fragments.count());
  }
  return fragments;
}

}  // namespace limber
