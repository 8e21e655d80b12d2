#include "elastic/solve_modes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/memory.h"

namespace limber {

void requireMemoryToSolve(uint64_t bytes) {
  requireMemory(bytes, "Solving this mesh as it is", "use the coarse solve, or reduce the mesh first");
}

EigenSolution solveModes(const SparsePencil& pencil, EigenOptions options, Job& job) {
  options.admit = requireMemoryToSolve;
  EigenSolution solution = solveEigenproblem(pencil, options, job);
  const size_t found = std::min(solution.inverseResidual.size(), static_cast<size_t>(exactCount(options))),
               trusted = solution.trustedCount(found);
  if (trusted < found)
    throw NoConvergence("The modes did not converge: only " + std::to_string(trusted) + " of " +
                        std::to_string(found) +
                        " can be trusted; remove needle triangles, weld the mesh or make the shell thicker.");
  return solution;
}

EigenSolution refineModes(const SparsePencil& pencil, const Eigen::MatrixXd& start, RefineOptions options,
                          Job& job) {
  options.admit = requireMemoryToSolve;
  return refineEigenpairs(pencil, start, options, job);
}

}  // namespace limber
