#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// The triangles of a surface, cut into one fragment for each lattice cell that they pass through. Two
// fragments of a triangle in cells with a common side are joined through that side, as all of these are
// convex.
struct Fragments {
  std::vector<uint32_t> start;  // triangle t has the fragments start[t] .. start[t + 1), cells ascending
  std::vector<uint32_t> cell;   // of each fragment

  uint32_t count() const { return static_cast<uint32_t>(cell.size()); }
  // The fragment of a triangle in a cell, or kNone.
  uint32_t find(uint32_t triangle, uint32_t cell) const;
};

// `points`: the vertices in lattice units. Each triangle has a fragment in the cell of each of its corners.
Fragments cutIntoFragments(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                           const LatticeGrid& grid, Job& job);

}  // namespace limber
