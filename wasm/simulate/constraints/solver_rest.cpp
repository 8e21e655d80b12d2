#include "simulate/constraints/solver_rest.h"

#include <cmath>

namespace limber {

namespace {

// A spring whose rest length is the distance of its ends.
Spring springBetween(const TriangleMesh& mesh, uint32_t a, uint32_t b, double stiffness) {
  return {a, b, length(mesh.positions[a] - mesh.positions[b]), stiffness};
}

}  // namespace

std::vector<Spring> edgeSprings(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                const Topology& topology) {
  std::vector<Spring> springs;
  for (const Topology::Edge& edge : topology.edges) {
    const double stiffness = solver.constants.stretch * factorOf(solver.stretchFactors, springs.size());
    springs.push_back(springBetween(mesh, edge.a, edge.b, stiffness));
  }
  return springs;
}

std::vector<Spring> crossSprings(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                 const Topology& topology) {
  std::vector<Spring> springs;
  for (const BendingEdge& edge : bendingEdges(mesh, topology)) {
    const double stiffness = solver.constants.bend * factorOf(solver.bendFactors, springs.size());
    springs.push_back(springBetween(mesh, edge.k, edge.l, stiffness));
  }
  return springs;
}

std::vector<RestHinge> hingesOf(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                const Topology& topology) {
  std::vector<RestHinge> hinges;
  for (const BendingEdge& edge : bendingEdges(mesh, topology)) {
    const double edgeLength = length(mesh.positions[edge.a] - mesh.positions[edge.b]);
    double stiffness = solver.constants.bend * factorOf(solver.bendFactors, hinges.size());
    if (solver.model.bend == BendElement::HingeByLength) stiffness *= edgeLength;
    if (solver.model.bend == BendElement::HingeByArea) stiffness *= 3 * edgeLength * edgeLength / edge.area;
    // Triangles without area have no dihedral angle.
    hinges.push_back({edge.k, edge.a, edge.b, edge.l, std::isfinite(stiffness) ? stiffness : 0});
  }
  return hinges;
}

}  // namespace limber
