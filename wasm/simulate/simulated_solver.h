#pragma once

#include <cstdint>
#include <vector>

#include "elastic/solvers/solver_model.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A solver of the panel on one mesh, with what tuning gives it. Constraints are numbered as in
// elastic/solvers/solver_constraints.h: triangles by index, or edges in the order of Topology::edges; bending
// constraints by the order of their edges, of which those with exactly two triangles bend.
struct SimulatedSolver {
  SolverModel model = {};
  SolverConstants constants = {};
  std::vector<double> stretchFactors = {};  // per stretch constraint, > 0; empty: 1
  std::vector<double> bendFactors = {};     // per bending constraint, > 0; empty: 1; never for Morley
  std::vector<double> masses = {};          // per vertex, kg, > 0; empty: by the rule of the model
};

// Throws std::invalid_argument with a sentence where constants, factors or masses are out of range, or are
// not as many as the mesh has constraints and vertices.
void requireSolver(const SimulatedSolver& solver, const TriangleMesh& mesh);

// The same solver on a mesh whose vertices are renumbered: vertex v becomes slotOf[v], triangles keep their
// order.
SimulatedSolver renumbered(const SimulatedSolver& solver, const TriangleMesh& mesh,
                           const std::vector<uint32_t>& slotOf);

}  // namespace limber
