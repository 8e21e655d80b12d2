#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "linear/refine_eigenpairs.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Finding the modes of a body by inverse iteration from those of nearly the same body, its start.

// Modes to compute beyond those that are wanted: a subspace converges as fast as the first mode left out
// allows.
inline constexpr int kSpareModes = 6;
// A body with at most this many unknowns is solved from scratch, which is fast.
inline constexpr int kFewUnknowns = 400;

// The unknowns of a body: how many there are, which are clamped, and how many rigid motions that leaves free.
struct StartUnknowns {
  Eigen::Index count;
  const std::vector<uint32_t>& clamped;
  int freeMotions;  // 6 where nothing is clamped
};

// For all modes of a start, which must have some. The tolerance and the number of steps are defaults.
RefineOptions refineOptions(const ModeBasis& start);
// The same without residuals, where only the first `count` modes have to be exact.
RefineOptions followOptions(const ModeBasis& start, int count);

// The columns to refine: the rigid motions that the clamped unknowns leave free, `freeMotions` in number,
// then those of a start. Rows of `phi` that are missing, such as those of edge rotations, and those of
// `clamped` are 0.
Eigen::MatrixXd startColumns(const TriangleMesh& mesh, const ModeBasis& start, const StartUnknowns& unknowns);

}  // namespace limber
