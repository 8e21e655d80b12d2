#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/solid/hexahedron.h"
#include "linear/sparse_pencil.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A solid body as a lattice of bricks, with its surface embedded.
struct SolidModel {
  SparsePencil pencil;  // unknowns 3 node + c, lumped masses, E = rho = 1
  // Vertex v moves as sum_k embeddingWeights[8 v + k] u(embeddingNodes[8 v + k]).
  std::vector<uint32_t> embeddingNodes;
  std::vector<double> embeddingWeights;
  double cellSize = 0;  // the longest side of a cell, in units of the mesh
};

struct SolidOptions {
  double poisson = 0.3;         // in (-1, 0.5)
  uint32_t targetCells = 2500;  // the approximate number of cells that contain a part of the body
};

// Stiffness and mass of a closed, oriented body: linear isotropic elasticity on partially filled bricks
// (finite cell method; hexahedron.h). `body` may have any number of outer surfaces and of cavities, which are
// wound the other way. All vertices must be used. Thin parts keep their true stiffness and mass, whatever the
// size of the cells. Each connected part has six rigid motions. O(n log n) in the triangles and the samples
// of filled cells. Throws Cancelled.
SolidModel solidModel(const TriangleMesh& body, const SolidOptions& options, Job& job);

// The measure of a lattice cell that its stiffness is computed from: a nearly empty cell gets a little
// additional filling (solid.cpp).
CellMeasure stiffnessMeasure(const CellMeasure& filled);

}  // namespace limber
