#include "simulate/constraints/solver_rest.h"

#include <cmath>

namespace limber {

namespace {

// The vertex of a triangle that is not on the edge.
uint32_t cornerOpposite(const Triangle& t, const Topology::Edge& edge) {
  for (const uint32_t v : t)
    if (v != edge.a && v != edge.b) return v;
  return edge.a;  // a triangle without area
}

// Calls visit(edge, index of the bending constraint) for all edges that bend.
template <class Visit>
void forEachBendingEdge(const Topology& topology, Visit visit) {
  size_t index = 0;
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount == 2) visit(edge, index++);
}

}  // namespace

std::vector<Spring> edgeSprings(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                const Topology& topology) {
  std::vector<Spring> springs;
  for (const Topology::Edge& edge : topology.edges) {
    const double stiffness = solver.constants.stretch * factorOf(solver.stretchFactors, springs.size());
    springs.push_back({edge.a, edge.b, length(mesh.positions[edge.a] - mesh.positions[edge.b]), stiffness});
  }
  return springs;
}

std::vector<Spring> crossSprings(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                 const Topology& topology) {
  std::vector<Spring> springs;
  forEachBendingEdge(topology, [&](const Topology::Edge& edge, size_t index) {
    const auto users = topology.trianglesAt(edge);
    const uint32_t k = cornerOpposite(mesh.triangles[users[0]], edge),
                   l = cornerOpposite(mesh.triangles[users[1]], edge);
    // Two triangles on the same three vertices have no corners to keep apart.
    const double stiffness = k == l ? 0 : solver.constants.bend * factorOf(solver.bendFactors, index);
    springs.push_back({k, k == l ? edge.a : l, 0, stiffness});
    springs.back().rest = length(mesh.positions[springs.back().a] - mesh.positions[springs.back().b]);
  });
  return springs;
}

std::vector<RestHinge> hingesOf(const SimulatedSolver& solver, const TriangleMesh& mesh,
                                const Topology& topology) {
  std::vector<RestHinge> hinges;
  forEachBendingEdge(topology, [&](const Topology::Edge& edge, size_t index) {
    const auto users = topology.trianglesAt(edge);
    const double edgeLength = length(mesh.positions[edge.a] - mesh.positions[edge.b]);
    double stiffness = solver.constants.bend * factorOf(solver.bendFactors, index);
    if (solver.model.bend == BendElement::HingeByLength) stiffness *= edgeLength;
    if (solver.model.bend == BendElement::HingeByArea)
      stiffness *=
          3 * edgeLength * edgeLength / (triangleArea(mesh, users[0]) + triangleArea(mesh, users[1]));
    const uint32_t apex = cornerOpposite(mesh.triangles[users[0]], edge),
                   flap = cornerOpposite(mesh.triangles[users[1]], edge);
    const bool isHinge = apex != flap && std::isfinite(stiffness);
    hinges.push_back({apex, edge.a, edge.b, apex == flap ? kNone : flap, isHinge ? stiffness : 0});
  });
  return hinges;
}

}  // namespace limber
