#pragma once

#include <span>
#include <vector>

#include "elastic/solvers/solver_constraints.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simulate/simulation_options.h"

namespace limber {

// A body as a solver moves it. All objects that it refers to must outlive the calls that take it.
struct MovingBody {
  const TriangleMesh& mesh;
  const Topology& topology;
  SolverConstants constants;             // include factors on all stretch or all bending constraints
  Pins pins = {};                        // the user's
  std::span<const double> masses = {};   // kg per vertex, each > 0; empty: those of the model's rule
  std::span<const double> factors = {};  // on the stiffness of each of the SolverConstraints; empty: 1
};

// The masses of a body, by the rule of the model if it has none of its own.
inline std::vector<double> massesOf(const MovingBody& body, const SolverModel& model) {
  if (body.masses.empty()) return solverMasses(body.mesh, model.mass, body.constants);
  return {body.masses.begin(), body.masses.end()};
}

}  // namespace limber
