#include "elastic/solid/lattice_pieces.h"

#include <algorithm>

namespace limber {

namespace {

constexpr uint32_t kSamplesPerCell = kSamples * kSamples * kSamples;

// Whether the segment passes through the cell at `position`; true in doubt.
bool runsThrough(const Vec3& from, const Vec3& to, const std::array<int, 3>& position) {
  constexpr double slack = 1e-12;
  double begin = 0, end = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = position[axis] - slack - from[axis], high = position[axis] + 1 + slack - from[axis];
    const double step = to[axis] - from[axis];
    if (step == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    begin = std::max(begin, std::min(low / step, high / step));
    end = std::min(end, std::max(low / step, high / step));
  }
  return begin <= end + slack;
}

}  // namespace

LatticePieces::LatticePieces(const LatticeGrid& grid, const Fragments& fragments,
                             const std::vector<RayFamily>& families)
    : grid_(grid), fragments_(fragments) {
  isCut_.assign(grid.cellCount(), 0);
  for (uint32_t cell : fragments.cell) isCut_[cell] = 1;
  numberItems(families);
}

void LatticePieces::numberItems(const std::vector<RayFamily>& families) {
  std::vector<uint8_t> isFilled = isCut_;
  for (const RayFamily& family : families)
    forEachSegment(family, [&](const RaySegment& segment) { isFilled[segment.cell] = 1; });
  itemStart_.assign(grid_.cellCount(), kNone);
  for (size_t cell = 0; cell < isFilled.size(); ++cell)
    if (isFilled[cell]) {
      itemStart_[cell] = fragmentItem_;
      fragmentItem_ += isCut_[cell] ? kSamplesPerCell : 1;
    }
  isUsed_.assign(fragmentItem_, 0);
  isUsed_.resize(fragmentItem_ + fragments_.count(), 1);
  sets_ = DisjointSets(isUsed_.size());
}

template <typename Visit>
void LatticePieces::forEachItem(const RayFamily& family, const RaySegment& segment,
                                const Visit& visit) const {
  if (!isCut_[segment.cell]) return visit(itemStart_[segment.cell]);
  std::array<int, 3> sample = segment.sample;
  for (int s = 0; s < kSamples; ++s) {
    const double position = samplePosition(family.axis, s);
    if (position < segment.begin || position > segment.end) continue;
    sample[family.axis] = s;
    visit(itemStart_[segment.cell] +
          static_cast<uint32_t>((sample[0] * kSamples + sample[1]) * kSamples + sample[2]));
  }
  for (uint32_t c = segment.firstCrossing; c < segment.lastCrossing; ++c) {
    const uint32_t fragment = fragments_.find(family.crossings[c].triangle, segment.cell);
    if (fragment != kNone) visit(fragmentItem_ + fragment);
  }
}

void LatticePieces::joinAlongEdge(uint32_t triangleA, uint32_t triangleB, const Vec3& from, const Vec3& to) {
  uint32_t a = fragments_.start[triangleA], b = fragments_.start[triangleB];
  const uint32_t endA = fragments_.start[triangleA + 1], endB = fragments_.start[triangleB + 1];
  const bool isInOneCell = endA - a == 1 && endB - b == 1;
  while (a < endA && b < endB) {
    const uint32_t cellA = fragments_.cell[a], cellB = fragments_.cell[b];
    if (cellA == cellB && (isInOneCell || runsThrough(from, to, grid_.positionOf(cellA))))
      joinFragments(a, b);
    if (cellA <= cellB) ++a;
    if (cellB <= cellA) ++b;
  }
}

void LatticePieces::joinAlongRays(const RayFamily& family) {
  forEachSegment(family, [&](const RaySegment& segment) {
    uint32_t before = kNone;
    forEachItem(family, segment, [&](uint32_t item) {
      isUsed_[item] = 1;
      if (before != kNone) sets_.unite(before, item);
      before = item;
    });
  });
}

void LatticePieces::numberCopies() {
  const auto itemCount = static_cast<uint32_t>(isUsed_.size());
  struct Piece {
    uint32_t cell, root;
  };
  std::vector<Piece> pieces;
  const auto add = [&](uint32_t item, uint32_t cell) {
    if (isUsed_[item] && sets_.rootOf(item) == item) pieces.push_back({cell, item});
  };
  for (uint32_t cell = 0; cell < itemStart_.size(); ++cell) {
    if (itemStart_[cell] == kNone) continue;
    for (uint32_t s = 0; s < (isCut_[cell] ? kSamplesPerCell : 1); ++s) add(itemStart_[cell] + s, cell);
  }
  for (uint32_t f = 0; f < fragments_.count(); ++f) add(fragmentItem_ + f, fragments_.cell[f]);
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.cell < b.cell; });
  copyOfItem_.assign(itemCount, kNone);
  for (const Piece& piece : pieces) {
    copyOfItem_[piece.root] = copyCount();
    cellOfCopy_.push_back(piece.cell);
  }
  for (uint32_t item = 0; item < itemCount; ++item)
    if (isUsed_[item]) copyOfItem_[item] = copyOfItem_[sets_.rootOf(item)];
}

uint32_t LatticePieces::copyOf(const RayFamily& family, const RaySegment& segment) const {
  uint32_t copy = kNone;
  forEachItem(family, segment, [&](uint32_t item) { copy = copyOfItem_[item]; });
  return copy;
}

}  // namespace limber
