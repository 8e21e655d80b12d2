#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// A box of equal, nearly cubic cells around a body. In lattice units cell (i, j, k) is
// [i, i + 1) x [j, j + 1) x [k, k + 1).
struct LatticeGrid {
  Vec3 origin, size;  // the low corner of the box, and the size of a cell, in units of the mesh
  std::array<int, 3> count = {0, 0, 0};  // cells along each axis

  size_t cellCount() const { return size_t(count[0]) * count[1] * count[2]; }
  uint32_t cellAt(int i, int j, int k) const {
    return static_cast<uint32_t>((size_t(i) * count[1] + j) * count[2] + k);
  }
  std::array<int, 3> positionOf(uint32_t cell) const {
    const auto [nx, ny, nz] = count;
    return {static_cast<int>(cell / (uint32_t(ny) * nz)), static_cast<int>(cell / nz % ny),
            static_cast<int>(cell % nz)};
  }
  // The index along one axis of the cell that contains a coordinate in lattice units.
  int along(int axis, double coordinate) const;
  uint32_t cellOf(const Vec3& point) const {
    return cellAt(along(0, point.x), along(1, point.y), along(2, point.z));
  }
  // The difference between the ids of neighbouring cells along an axis.
  uint32_t stride(int axis) const {
    return axis == 0 ? uint32_t(count[1]) * count[2] : axis == 1 ? uint32_t(count[2]) : 1;
  }
};

// A grid that divides the bounding box evenly into cells of which about `targetCells` contain a part of the
// body. The box is larger than the body by a millionth of a cell, asymmetrically, so that no side of the body
// and no plane of symmetry coincides with cell faces.
LatticeGrid latticeGrid(const TriangleMesh& body, uint32_t targetCells);
// The same with cells that are as close to `cellSize` as an even division of the box allows. Given the cell
// size of another grid, a body with nearly the same box gets the same number of cells along each axis.
LatticeGrid latticeGrid(const TriangleMesh& body, const Vec3& cellSize);

// A closed surface within its lattice.
struct LatticeSurface {
  const std::vector<Vec3>& points;  // its vertices in lattice units
  const std::vector<Triangle>& triangles;
  const LatticeGrid& grid;
  int sign = 1;  // -1 if the surface is wound inwards
};

// The vertices in lattice units.
std::vector<Vec3> inLatticeUnits(const TriangleMesh& body, const LatticeGrid& grid);

// The longest of the three sides of a cell.
double longestSide(const Vec3& cell);

}  // namespace limber
