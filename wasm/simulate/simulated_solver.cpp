#include "simulate/simulated_solver.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/topology.h"

namespace limber {

namespace {

void require(bool isMet, const std::string& sentence) {
  if (!isMet) throw std::invalid_argument(sentence);
}

bool arePositive(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value) && value > 0; });
}

// `what` is the subject of a sentence in the plural.
void requireCount(const std::vector<double>& values, size_t count, const std::string& what) {
  require(values.empty() || values.size() == count,
          what + " are " + std::to_string(values.size()) + ", but the mesh needs " + std::to_string(count) +
              ": take the settings that were written for this mesh.");
  require(arePositive(values), what + " must be finite and above 0.");
}

// The vertex of a triangle that is not on the edge; kNone if it has no such corner.
uint32_t cornerOpposite(const Triangle& t, const Topology::Edge& edge) {
  for (const uint32_t v : t)
    if (v != edge.a && v != edge.b) return v;
  return kNone;
}

// Factors of edges, in the order of the edges after renumbering.
template <class Edges>
std::vector<double> sortedFactors(const std::vector<double>& factors, const Edges& edges,
                                  const std::vector<uint32_t>& slotOf) {
  std::vector<std::pair<std::pair<uint32_t, uint32_t>, double>> entries;
  for (size_t i = 0; i < factors.size(); ++i)
    entries.push_back({std::minmax({slotOf[edges[i].a], slotOf[edges[i].b]}), factors[i]});
  std::ranges::sort(entries);
  std::vector<double> sorted;
  for (const auto& entry : entries) sorted.push_back(entry.second);
  return sorted;
}

}  // namespace

std::vector<BendingEdge> bendingEdges(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<BendingEdge> bending;
  for (const Topology::Edge& edge : topology.edges) {
    if (edge.useCount != 2) continue;
    const auto users = topology.trianglesAt(edge);
    const uint32_t k = cornerOpposite(mesh.triangles[users[0]], edge),
                   l = cornerOpposite(mesh.triangles[users[1]], edge);
    if (k == kNone || l == kNone || k == l) continue;
    bending.push_back({edge.a, edge.b, k, l, triangleArea(mesh, users[0]) + triangleArea(mesh, users[1])});
  }
  return bending;
}

void requireSolver(const SimulatedSolver& solver, const TriangleMesh& mesh) {
  const auto& [stretch, second, bend, poisson, surfaceDensity, unit] = solver.constants;
  require(arePositive({stretch, surfaceDensity, unit}),
          "The stretch constant, the surface density and the unit of a solver must be finite and above 0.");
  require(std::isfinite(bend) && bend >= 0, "The bend constant of a solver must be at least 0.");
  require(poisson > -1 && poisson < 1, "Poisson's ratio of a solver must lie between -1 and 1.");
  // nu = lambda / (lambda + 2 mu) is then in (-1, 1).
  require(std::isfinite(second) && second > -stretch,
          "The second stretch constant of a solver must be above minus the first.");
  const Topology topology = buildIncidence(mesh);
  const bool isMembrane = solver.model.stretch == StretchElement::Membrane;
  requireCount(solver.stretchFactors, isMembrane ? mesh.triangleCount() : topology.edges.size(),
               "The factors on stretching");
  require(solver.model.bend != BendElement::Morley || solver.bendFactors.empty(),
          "The shell takes no factors on single bending constraints: leave them out.");
  requireCount(solver.bendFactors, bendingEdges(mesh, topology).size(), "The factors on bending");
  requireCount(solver.masses, mesh.vertexCount(), "The masses");
}

SimulatedSolver renumbered(const SimulatedSolver& solver, const TriangleMesh& mesh,
                           const std::vector<uint32_t>& slotOf) {
  SimulatedSolver out = solver;
  for (size_t v = 0; v < solver.masses.size(); ++v) out.masses[slotOf[v]] = solver.masses[v];
  if (solver.stretchFactors.empty() && solver.bendFactors.empty()) return out;
  const Topology topology = buildIncidence(mesh);
  if (solver.model.stretch == StretchElement::EdgeSprings)
    out.stretchFactors = sortedFactors(solver.stretchFactors, topology.edges, slotOf);
  out.bendFactors = sortedFactors(solver.bendFactors, bendingEdges(mesh, topology), slotOf);
  return out;
}

}  // namespace limber
