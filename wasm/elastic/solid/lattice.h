#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/solid/hexahedron.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// The inside of a closed surface as cells of a regular lattice. A cell with several pieces of the inside that
// are not connected within it exists once for each piece, as copies, so that close limbs do not fuse. Copies
// in neighbouring cells share the nodes of their common side if their pieces are connected through it. Every
// cell that the surface touches has at least one copy, however thin the body is there.
struct Lattice {
  LatticeGrid grid;
  std::vector<uint32_t> cells;      // per copy: its cell of the grid
  std::vector<uint32_t> copyNodes;  // [8 * copy + corner], corners as in `trilinearWeights`
  std::vector<CellMeasure> filled;  // per copy
  // Per copy, [4 * axis + lateral]: the share of the cell's cross-section in which the body ends on the far
  // side of the axis, minus the share in which it ends on the near side. `lateral` counts the four edges of
  // the cell along the axis, by whose bilinear weights the shares are split: its side along axis + 1, plus
  // twice that along axis + 2.
  std::vector<std::array<double, 12>> ends;
  uint32_t nodeCount = 0;
  std::vector<Vec3> points;            // the vertices of the body in lattice units
  std::vector<uint32_t> copyOfVertex;  // per vertex: the copy whose piece it bounds

  uint32_t copyCount() const { return static_cast<uint32_t>(filled.size()); }
};

// `body` must be closed and oriented. `targetCells`: the approximate number of copies. Deterministic. O(n log
// n) in the triangles and the samples of filled cells. Throws Cancelled.
Lattice buildLattice(const TriangleMesh& body, uint32_t targetCells, Job& job);
// The same with cells of about the given size, see `latticeGrid`.
Lattice buildLattice(const TriangleMesh& body, const Vec3& cellSize, Job& job);

}  // namespace limber
