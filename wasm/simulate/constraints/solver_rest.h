#pragma once

#include <vector>

#include "mesh/topology.h"
#include "simulate/constraints/edge_constraints.h"
#include "simulate/constraints/hinge_constraints.h"
#include "simulate/simulated_solver.h"

namespace limber {

// Springs on all edges, or between the corners opposite each bending edge. `mesh` is in metres.
std::vector<Spring> edgeSprings(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                const Topology& topology);
std::vector<Spring> crossSprings(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                 const Topology& topology);
// The hinges of any model that has them. `mesh` is in metres.
std::vector<RestHinge> hingesOf(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                const Topology& topology);

}  // namespace limber
