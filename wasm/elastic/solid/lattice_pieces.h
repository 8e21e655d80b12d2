#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/disjoint_sets.h"
#include "elastic/solid/lattice_fragments.h"
#include "elastic/solid/lattice_rays.h"

namespace limber {

// The part of an interval of a ray within one cell.
struct Stretch {
  uint32_t cell;
  std::array<int, 3> sample;  // numbers of the ray's samples within the cell; its own axis is unused
  double begin, end;          // along the ray within the cell, in [0, 1]
  bool isFirst, isLast;       // the interval begins, ends in this cell
  uint32_t firstCrossing, lastCrossing;  // the interval's crossings in this cell are [first, last)
};

// The pieces of the body's inside in each cell. A piece consists of sample points and fragments of the
// surface (items) that are connected within the cell: along rays, and across edges of the surface. A cell
// without any fragment is one single item. Each piece becomes a copy of its cell.
class LatticePieces {
 public:
  LatticePieces(const LatticeGrid& grid, const Fragments& fragments, const std::vector<RayFamily>& families);

  // Two fragments of triangles that touch within the fragments' common cell.
  void joinFragments(uint32_t a, uint32_t b) { sets_.unite(fragmentItem_ + a, fragmentItem_ + b); }
  // Two triangles with a common edge between `from` and `to` (lattice units) are connected where it runs.
  void joinAlongEdge(uint32_t triangleA, uint32_t triangleB, const Vec3& from, const Vec3& to);
  void joinAlongRays(const RayFamily& family);
  // To be called once all is joined; copies are numbered by cell, then by their first item.
  void numberCopies();

  uint32_t copyCount() const { return static_cast<uint32_t>(cellOfCopy_.size()); }
  // Ascending.
  const std::vector<uint32_t>& cellsOfCopies() const { return cellOfCopy_; }
  uint32_t cellOfCopy(uint32_t copy) const { return cellOfCopy_[copy]; }
  uint32_t copyOfFragment(uint32_t fragment) const { return copyOfItem_[fragmentItem_ + fragment]; }
  // The copy that a stretch runs through, or kNone where it is too short to tell.
  uint32_t copyOf(const RayFamily& family, const Stretch& stretch) const;

  // Calls visit(stretch) for each stretch of a family's intervals, ray by ray.
  template <typename Visit>
  void forEachStretch(const RayFamily& family, const Visit& visit) const;

 private:
  void numberItems(const std::vector<RayFamily>& families);
  // Calls visit(item) for each item on a stretch.
  template <typename Visit>
  void forEachItem(const RayFamily& family, const Stretch& stretch, const Visit& visit) const;

  const LatticeGrid& grid_;
  const Fragments& fragments_;
  std::vector<uint8_t> isCut_;       // per cell: has a fragment
  std::vector<uint32_t> itemStart_;  // per cell: its first sample's item, kNone where the cell is empty
  uint32_t fragmentItem_ = 0;        // the item of fragment 0; those of samples come before
  std::vector<uint8_t> isUsed_;      // per item
  DisjointSets sets_;
  std::vector<uint32_t> copyOfItem_, cellOfCopy_;
};

template <typename Visit>
void LatticePieces::forEachStretch(const RayFamily& family, const Visit& visit) const {
  const int axis = family.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto raysAlongV = static_cast<uint32_t>(grid_.count[v] * kSamples);
  for (const RayFamily::Interval& interval : family.intervals) {
    const uint32_t ray = family.crossings[interval.first].ray;
    const int a = static_cast<int>(ray / raysAlongV), b = static_cast<int>(ray % raysAlongV);
    const double begin = family.crossings[interval.first].depth, end = family.crossings[interval.last].depth;
    const int first = grid_.along(axis, begin), last = grid_.along(axis, end);
    std::array<int, 3> place;
    Stretch stretch;
    stretch.sample[axis] = 0;
    stretch.sample[u] = a % kSamples;
    stretch.sample[v] = b % kSamples;
    place[u] = a / kSamples;
    place[v] = b / kSamples;
    stretch.lastCrossing = interval.first;
    for (int c = first; c <= last; ++c) {
      place[axis] = c;
      stretch.cell = grid_.cellAt(place[0], place[1], place[2]);
      stretch.begin = c == first ? begin - c : 0;
      stretch.end = c == last ? end - c : 1;
      stretch.isFirst = c == first;
      stretch.isLast = c == last;
      stretch.firstCrossing = stretch.lastCrossing;
      while (stretch.lastCrossing <= interval.last &&
             grid_.along(axis, family.crossings[stretch.lastCrossing].depth) <= c)
        ++stretch.lastCrossing;
      visit(stretch);
    }
  }
}

}  // namespace limber
