#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "linear/sparse_pencil.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A solid body as a lattice of bricks in which its surface is embedded.
struct SolidModel {
  SparsePencil pencil;  // three unknowns per lattice node, lumped masses, E = 1, rho = 1
  // Vertex v moves as sum_k embeddingWeights[8 v + k] u(embeddingNodes[8 v + k]).
  std::vector<uint32_t> embeddingNodes;
  std::vector<double> embeddingWeights;
  double cellSize = 0;  // the longest side of a cell, in units of the mesh
};

struct SolidOptions {
  double poisson = 0.3;
  uint32_t targetCells = 2500;  // a wish for the number of cells that hold a part of the body
};

// `body`: closed and oriented, any number of shells, those of cavities turned the other way; every vertex is
// used. Thin parts keep their own stiffness and mass, whatever the size of the cells. Each part that is
// connected has six rigid motions. Throws Cancelled.
SolidModel solidModel(const TriangleMesh& body, const SolidOptions& options, Job& job);

}  // namespace limber
