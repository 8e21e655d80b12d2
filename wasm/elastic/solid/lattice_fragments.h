#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// The triangles of a surface, cut into one fragment for each lattice cell that they pass through. Triangles
// and cells are convex, so two fragments of a triangle in cells with a common face are connected through that
// face.
struct Fragments {
  std::vector<uint32_t>
      start;                   // triangle t has the fragments start[t] .. start[t + 1) - 1, by ascending cell
  std::vector<uint32_t> cell;  // per fragment

  uint32_t count() const { return static_cast<uint32_t>(cell.size()); }
  // The fragment of a triangle in a cell, or kNone.
  uint32_t find(uint32_t triangle, uint32_t cell) const;
};

// Each triangle has a fragment in the cell of each of its corners. Throws Cancelled.
Fragments cutIntoFragments(const LatticeSurface& surface, Job& job);

}  // namespace limber
