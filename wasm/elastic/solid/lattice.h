#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/solid/hexahedron.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// The inside of a closed surface as cells of a regular lattice. If a cell contains several disconnected
// pieces of the inside, it has one copy for each piece, so that close limbs do not fuse. Copies in
// neighbouring cells share the nodes of their common face if their pieces are connected through it. Every
// cell that the surface touches has at least one copy, however thin the body is there.
struct Lattice {
  LatticeGrid grid;
  std::vector<uint32_t> cells;      // per copy: its cell in the grid
  std::vector<uint32_t> copyNodes;  // [8 * copy + corner], corners as in `trilinearWeights`
  std::vector<CellMeasure> filled;  // per copy
  // Per copy, [4 * axis + lateral]: the fraction of the cell's cross-section in which the body ends towards
  // the positive end of the axis, minus the fraction in which it ends towards the negative end. `lateral` is
  // the index of one of the four edges of the cell along the axis, among which the fractions are split by
  // bilinear weights: its side (0 or 1) along axis + 1, plus twice that along axis + 2.
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
