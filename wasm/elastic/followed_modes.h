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
// A body with no more unknowns is solved from scratch in no time.
inline constexpr int kFewUnknowns = 400;

// For all modes of a start, which must have some. The tolerance and the number of steps are defaults.
RefineOptions refineOptions(const ModeBasis& start);
// The same without residuals, where only the first `count` modes have to be exact.
RefineOptions followOptions(const ModeBasis& start, int count);

// The columns to refine: the six rigid motions of a body without clamped unknowns, then those of a start.
// Rows of `phi` that are missing, such as those of edge rotations, and those of `clamped` are 0.
Eigen::MatrixXd startColumns(const TriangleMesh& mesh, const Eigen::MatrixXd& phi, Eigen::Index unknownCount,
                             const std::vector<uint32_t>& clamped);

}  // namespace limber
