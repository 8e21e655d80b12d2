#pragma once

#include <cstdint>
#include <vector>

#include "elastic/solvers/solver_model.h"
#include "mesh/topology.h"

namespace limber {

// A solver model on one mesh, with its tuned parameters. Constraints are numbered as in
// elastic/solvers/solver_constraints.h: triangles by index, or edges in the order of Topology::edges; bending
// constraints in the order of `bendingEdges`.
struct SimulatedSolver {
  SolverModel model = {};
  SolverConstants constants = {};
  std::vector<double> stretchFactors = {};  // per stretch constraint, > 0; empty: 1
  std::vector<double> bendFactors = {};     // per bending constraint, > 0; empty: 1; never for Morley
  std::vector<double> masses = {};          // per vertex, kg, > 0; empty: by the rule of the model
};

// An edge from a to b with bending resistance, and the corners opposite to it.
struct BendingEdge {
  uint32_t a, b, k, l;
  double area;  // of both triangles, in units of the mesh
};
// The edges with exactly two triangles and two different corners opposite, in the order of Topology::edges.
std::vector<BendingEdge> bendingEdges(const TriangleMesh& mesh, const Topology& topology);

// Throws std::invalid_argument with a sentence if constants, factors or masses are out of range, or if their
// numbers do not match the constraints and vertices of the mesh.
void requireSolver(const SimulatedSolver& solver, const TriangleMesh& mesh);

// The same solver on a mesh with renumbered vertices: vertex v becomes slotOf[v], triangles keep their order.
SimulatedSolver renumbered(const SimulatedSolver& solver, const TriangleMesh& mesh,
                           const std::vector<uint32_t>& slotOf);

}  // namespace limber
