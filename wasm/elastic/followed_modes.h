#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "linear/refine_eigenpairs.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Finds the modes of a body by inverse iteration from a start: the modes of nearly the same body.

// Modes to compute in addition to the wanted ones: the first mode outside the subspace limits how fast it
// converges.
inline constexpr int kSpareModes = 6;
// Bodies with at most this many unknowns are solved from scratch, which is fast enough.
inline constexpr int kFewUnknowns = 400;

// The unknowns of a body: their number, which of them are clamped, and the number of rigid motions that
// remain free.
struct StartUnknowns {
  Eigen::Index count;
  const std::vector<uint32_t>& clamped;
  int freeMotions;  // 6 if nothing is clamped
};

// Options that refine all modes of a start, which must have some, with the default tolerance and number of
// steps.
RefineOptions refineOptions(const ModeBasis& start);
// The same without residuals; only the first `count` modes have to be exact.
RefineOptions followOptions(const ModeBasis& start, int count);

// The columns to refine: the `freeMotions` rigid motions that the clamped unknowns leave free, then those of
// a start. Rows that `phi` lacks, such as those of edge rotations, and rows of `clamped` unknowns are 0.
Eigen::MatrixXd startColumns(const TriangleMesh& mesh, const ModeBasis& start, const StartUnknowns& unknowns);

}  // namespace limber
