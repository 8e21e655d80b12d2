#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/disjoint_sets.h"
#include "elastic/solid/lattice_fragments.h"
#include "elastic/solid/lattice_rays.h"

namespace limber {

// The part of an interval of a ray within one cell.
struct RaySegment {
  uint32_t cell;
  std::array<int, 3> sample;  // the ray's samples within the cell; the entry of its own axis is unused
  double begin, end;          // along the ray within the cell, in [0, 1]
  bool isFirst, isLast;       // whether the interval begins and ends in this cell
  uint32_t firstCrossing, lastCrossing;  // the crossings in this cell: [firstCrossing, lastCrossing)
};

// The connected pieces of the body's inside in each cell. A piece consists of items, sample points and
// fragments of the surface, that are connected within the cell along rays and across edges of the surface. A
// cell without any fragment is a single item. Each piece becomes a copy of its cell.
class LatticePieces {
 public:
  LatticePieces(const LatticeGrid& grid, const Fragments& fragments, const std::vector<RayFamily>& families);

  // Joins two fragments of the same cell whose triangles touch in that cell.
  void joinFragments(uint32_t a, uint32_t b) { sets_.unite(fragmentItem_ + a, fragmentItem_ + b); }
  // Joins the fragments of two triangles in all cells through which their common edge from `from` to `to`
  // runs.
  void joinAlongEdge(uint32_t triangleA, uint32_t triangleB, const Vec3& from, const Vec3& to);
  void joinAlongRays(const RayFamily& family);
  // Must be called after all joins. Copies are numbered by cell, then by their first item.
  void numberCopies();

  uint32_t copyCount() const { return static_cast<uint32_t>(cellOfCopy_.size()); }
  // Per copy, ascending.
  const std::vector<uint32_t>& cellsOfCopies() const { return cellOfCopy_; }
  uint32_t cellOfCopy(uint32_t copy) const { return cellOfCopy_[copy]; }
  uint32_t copyOfFragment(uint32_t fragment) const { return copyOfItem_[fragmentItem_ + fragment]; }
  // The copy that a segment passes through, or kNone if the segment is too short to contain an item.
  uint32_t copyOf(const RayFamily& family, const RaySegment& segment) const;

  // Calls visit(segment) for each cell that each interval of a family passes through, ray by ray.
  template <typename Visit>
  void forEachSegment(const RayFamily& family, const Visit& visit) const;

 private:
  void numberItems(const std::vector<RayFamily>& families);
  // Calls visit(item) for each item on a segment.
  template <typename Visit>
  void forEachItem(const RayFamily& family, const RaySegment& segment, const Visit& visit) const;

  const LatticeGrid& grid_;
  const Fragments& fragments_;
  std::vector<uint8_t> isCut_;       // per cell: whether it has a fragment
  std::vector<uint32_t> itemStart_;  // per cell: the item of its first sample; kNone if the cell is empty
  uint32_t fragmentItem_ = 0;        // the item of fragment 0; all items of samples come before
  std::vector<uint8_t> isUsed_;      // per item
  DisjointSets sets_;
  std::vector<uint32_t> copyOfItem_, cellOfCopy_;
};

template <typename Visit>
void LatticePieces::forEachSegment(const RayFamily& family, const Visit& visit) const {
  const int axis = family.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto raysAlongV = static_cast<uint32_t>(grid_.count[v] * kSamples);
  for (const RayFamily::Interval& interval : family.intervals) {
    const uint32_t ray = family.crossings[interval.first].ray;
    const int a = static_cast<int>(ray / raysAlongV), b = static_cast<int>(ray % raysAlongV);
    const double begin = family.crossings[interval.first].depth, end = family.crossings[interval.last].depth;
    const int first = grid_.along(axis, begin), last = grid_.along(axis, end);
    std::array<int, 3> position;
    RaySegment segment;
    segment.sample[axis] = 0;
    segment.sample[u] = a % kSamples;
    segment.sample[v] = b % kSamples;
    position[u] = a / kSamples;
    position[v] = b / kSamples;
    segment.lastCrossing = interval.first;
    for (int c = first; c <= last; ++c) {
      position[axis] = c;
      segment.cell = grid_.cellAt(position[0], position[1], position[2]);
      segment.begin = c == first ? begin - c : 0;
      segment.end = c == last ? end - c : 1;
      segment.isFirst = c == first;
      segment.isLast = c == last;
      segment.firstCrossing = segment.lastCrossing;
      while (segment.lastCrossing <= interval.last &&
             grid_.along(axis, family.crossings[segment.lastCrossing].depth) <= c)
        ++segment.lastCrossing;
      visit(segment);
    }
  }
}

}  // namespace limber
