#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "elastic/parts.h"
#include "linear/mode_basis.h"

namespace limber {

// The elastic modes of one part in its frame (E = rho = diagonal = 1).
struct PartModes {
  uint32_t zeroModesExpected = 0, zeroModesFound = 0;
  // phi(3 v + c, k): displacements of the part's vertices. Instead of mass-normalised, columns are normalised
  // by normaliseShape.
  ModeBasis basis;
  std::vector<double> residual;  // per mode, see Mode::residual
  std::vector<int32_t> axis;     // per mode, see Mode::axis
  uint64_t factorNonzeros = 0;
  uint32_t coarseVertices = 0;  // see ComponentModes::coarseVertices
  std::string failure = {};     // see ComponentModes::failure
};

// The approximate number of cells in the lattice of a solid part. A lattice that is only used for guidance
// need not be finer than the triangles that it guides: strain is one number per triangle, and a cube of n
// cells has 6 n^(2/3) cell faces on its surface, so (faces / 6)^(3/2) cells resolve it. At most
// kGuidingCells, whose ranks hardly differ from those of finer lattices (docs/modes.md).
uint32_t latticeCells(const Part& part, const ModesOptions& options);

// Solves one part with its own elastic model. A part whose vertices are all pinned has no modes. Throws as
// computeModes.
PartModes solvePart(const Part& part, const ModesOptions& options, Job& job);

// The modes of a shell from approximate ones, by inverse iteration on the part itself until its frequencies
// change by less than 1e-4. Zero modes are copied from `start`. Throws as computeModes.
PartModes refineShell(const Part& part, const PartModes& start, const ModesOptions& options, Job& job);

// Scales a shape, shape[3 v + c], to a largest displacement of 1 whose largest component is positive.
void normaliseShape(Eigen::Ref<Eigen::VectorXd> shape);

}  // namespace limber
