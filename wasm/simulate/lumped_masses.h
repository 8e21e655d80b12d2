#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/sheet.h"
#include "simulate/simulated_solver.h"

namespace limber {

// The mass of every vertex in kg: those of the solver, or by the rule of its model. By area, which is also
// the rule without a solver (null), a vertex gets at least 1e-9 of the mean. `mesh` is in metres. Throws
// std::invalid_argument if the mesh has no area.
std::vector<double> lumpedMasses(const TriangleMesh& mesh, const Sheet& sheet, const SimulatedSolver* solver);

}  // namespace limber
