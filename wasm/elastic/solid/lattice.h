#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/solid/hexahedron.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// The inside of a closed surface as cells of a regular lattice. A cell that holds several pieces of the
// inside which are not connected within it comes once for each (a copy), so that close limbs do not fuse.
// Copies in neighbouring cells share the nodes of their common side where their pieces are connected through
// it. Every cell that the surface touches has at least one copy, however thin the body is there.
struct Lattice {
  LatticeGrid grid;
  std::vector<uint32_t> copyNodes;  // [8 * copy + corner], corners as in `trilinearWeights`
  std::vector<CellMeasure> filled;  // of each copy
  // [4 * axis + lateral] of each copy: the share of the cell's cross-section where the body ends on the far
  // side of the axis less that where it ends on the near side, by the bilinear weights of the cell's four
  // edges along the axis (lateral = side along axis + 1, plus twice that along axis + 2).
  std::vector<std::array<double, 12>> ends;
  uint32_t nodeCount = 0;
  std::vector<Vec3> points;            // the vertices in lattice units
  std::vector<uint32_t> copyOfVertex;  // the copy of the piece that the vertex bounds

  uint32_t copyCount() const { return static_cast<uint32_t>(filled.size()); }
};

// `body`: closed and oriented. The result depends on nothing else but `targetCells`, a wish for the number of
// copies. O(n log n) in the triangles and the samples of the filled cells.
Lattice buildLattice(const TriangleMesh& body, uint32_t targetCells, Job& job);

}  // namespace limber
