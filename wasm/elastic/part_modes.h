#pragma once

#include "elastic/parts.h"

namespace limber {

// The elastic modes of one part in units of its frame (E = rho = diagonal = 1): shapes over its vertices,
// largest displacement 1.
struct PartModes {
  uint32_t zeroModesExpected = 0, zeroModesFound = 0;
  std::vector<double> omega, residual;
  std::vector<int32_t> axis;
  std::vector<std::vector<Vec3>> shapes;
  uint64_t factorNonzeros = 0;
  uint32_t coarseVertices = 0;
};

// Solves one part with its own model. A part all of whose vertices are pinned has no modes.
PartModes solvePart(const Part& part, const ModesOptions& options, Job& job);

// Modes of a shell from approximate shapes of them, by inverse iteration on the part itself until frequencies
// stand to 1e-4. Zero modes are those of the start.
PartModes refineShell(const Part& part, const PartModes& start, const ModesOptions& options, Job& job);

// Scales a shape to a largest displacement of 1 and turns it so that the largest component there is positive.
void normaliseShape(std::vector<Vec3>& shape);

// The modes of all parts as one set, named and sorted.
ModeSet collectModes(const TriangleMesh& body, const std::vector<Part>& parts,
                     const std::vector<PartModes>& modes, const ModesOptions& options);

// Throws std::invalid_argument with one sentence.
void checkModesOptions(const TriangleMesh& mesh, const ModesOptions& options);

}  // namespace limber
