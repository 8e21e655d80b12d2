#pragma once

#include <array>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "modes/hexahedron.h"

namespace limber {

// A piece of the inside within one cell.
struct Sliver {
  const std::vector<Vec3>& points;         // in lattice units
  const std::vector<Triangle>& triangles;  // of the body
  const std::vector<uint32_t>& around;     // those that bound the piece within the cell
  std::array<int, 3> place;                // of the cell
  int sign;                                // -1 where the body is wound inwards
};

// How a piece that the lattice's rays hardly meet fills its cell: by rays of its own, spread evenly over the
// box around the piece. Only what lies between two of the piece's own triangles counts, so of a piece that
// reaches from one side of the cell to the other something may be missed; of the three directions the one
// that finds most is taken. Exact for struts and plates along the axes.
CellMeasure measureSliver(const Sliver& sliver);

}  // namespace limber
