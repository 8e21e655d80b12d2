#pragma once

#include <array>
#include <vector>

#include "elastic/solid/hexahedron.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A piece of the inside within one cell.
struct Sliver {
  const std::vector<Vec3>& points;         // in lattice units
  const std::vector<Triangle>& triangles;  // of the body
  const std::vector<uint32_t>& around;     // those that bound the piece within the cell
  std::array<int, 3> place;                // of the cell
  int sign;                                // -1 where the body is wound inwards
  bool isMet;                              // some ray of the lattice runs through it
};

// How a piece that is too thin for the lattice's rays fills its cell: by rays of its own, spread evenly over
// the box around its surface. They see the piece's triangles within the cell and nothing else: a ray that
// runs inside from one side of the cell to the other finds nothing. Of the three directions the one that
// finds most is taken. Exact for struts and plates along the axes. Zero where the surface faces inwards along
// all axes, as folds do that are turned inside out.
CellMeasure measureSliver(const Sliver& sliver);

}  // namespace limber
