#pragma once

#include <array>
#include <vector>

#include "elastic/solid/hexahedron.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// A piece of the inside within one cell.
struct Sliver {
  const LatticeSurface& surface;
  const std::vector<uint32_t>& around;  // the triangles that bound the piece within the cell
  std::array<int, 3> position;          // of the cell
  bool isMet;                           // whether a ray of the lattice passes through it
};

// Measures how a piece that is too thin for the rays of the lattice fills its cell, with additional rays
// spread evenly over the bounding box of its surface. These rays are tested only against the triangles of the
// piece within the cell: a ray that stays inside the body from one side of the cell to the other finds
// nothing. The direction that finds the largest volume is used. Exact for struts and plates along the axes.
// Zero if the surface faces inwards along all axes, as inside-out folds do.
CellMeasure measureSliver(const Sliver& sliver);

}  // namespace limber
