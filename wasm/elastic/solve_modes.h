#pragma once

#include <cstdint>

#include "base/job.h"
#include "linear/refine_eigenpairs.h"

namespace limber {

// solveEigenproblem and refineEigenpairs for vibrations, with error messages for the user. Both throw
// Cancelled, and std::runtime_error with a sentence if memory is short; solveModes throws NoConvergence if a
// mode is not accurate enough.
EigenSolution solveModes(const SparsePencil& pencil, EigenOptions options, Job& job);
EigenSolution refineModes(const SparsePencil& pencil, const Eigen::MatrixXd& start, RefineOptions options,
                          Job& job);

// Throws std::runtime_error with a sentence if a solve that takes `bytes` does not fit into memory.
void requireMemoryToSolve(uint64_t bytes);

}  // namespace limber
