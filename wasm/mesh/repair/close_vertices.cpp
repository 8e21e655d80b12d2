#include "mesh/repair/close_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/disjoint_sets.h"

namespace limber {
namespace {

using Cell = std::array<double, 3>;  // integers stored as doubles, which cannot overflow

// A point and its cell of a grid. Entries are sorted by cell, then by point.
struct Entry {
  Cell cell;
  uint32_t point;

  bool operator<(const Entry& other) const {
    return cell != other.cell ? cell < other.cell : point < other.point;
  }
};

std::vector<Entry> sortIntoCells(const std::vector<Vec3>& points, double size) {
  std::vector<Entry> entries(points.size());
  for (uint32_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    entries[i] = {{std::floor(p.x / size), std::floor(p.y / size), std::floor(p.z / size)}, i};
  }
  std::ranges::sort(entries, std::less<>());
  return entries;
}

}  // namespace

std::vector<uint32_t> uniteCloseVertices(const std::vector<Vec3>& points, double distance, Job& job) {
  DisjointSets sets(points.size());
  if (!(distance > 0)) return sets.roots();
  const auto entries = sortIntoCells(points, distance);
  const auto unite = [&](uint32_t i, uint32_t j) {
    if (squaredLength(points[i] - points[j]) < distance * distance) sets.unite(i, j);
  };
  for (const Entry& entry : entries) {
    if (entry.point % 256 == 0) job.check();
    // Cells that differ only in z are adjacent in the sorted entries.
    for (double dx = -1; dx <= 1; ++dx)
      for (double dy = -1; dy <= 1; ++dy) {
        const Cell low{entry.cell[0] + dx, entry.cell[1] + dy, entry.cell[2] - 1};
        const Cell high{low[0], low[1], entry.cell[2] + 1};
        auto other = std::lower_bound(entries.begin(), entries.end(), Entry{low, 0});
        for (; other != entries.end() && other->cell <= high; ++other)
          if (other->point < entry.point) unite(other->point, entry.point);
      }
  }
  return sets.roots();
}

}  // namespace limber
