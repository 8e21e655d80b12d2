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

bool bends(const Topology::Edge& edge) {
  return edge.useCount == 2;
}

size_t bendingCount(const Topology& topology) {
  return static_cast<size_t>(std::ranges::count_if(topology.edges, bends));
}

// Factors of edges (of those that bend, with `onlyBending`) in the order that they have after renumbering.
std::vector<double> sortedFactors(const std::vector<double>& factors, const Topology& topology,
                                  const std::vector<uint32_t>& slotOf, bool onlyBending) {
  std::vector<std::pair<std::pair<uint32_t, uint32_t>, double>> entries;
  for (const Topology::Edge& edge : topology.edges) {
    if (factors.empty() || (onlyBending && !bends(edge))) continue;
    entries.push_back({std::minmax({slotOf[edge.a], slotOf[edge.b]}), factors[entries.size()]});
  }
  std::ranges::sort(entries);
  std::vector<double> sorted;
  for (const auto& entry : entries) sorted.push_back(entry.second);
  return sorted;
}

}  // namespace

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
  requireCount(solver.bendFactors, bendingCount(topology), "The factors on bending");
  requireCount(solver.masses, mesh.vertexCount(), "The masses");
}

SimulatedSolver renumbered(const SimulatedSolver& solver, const TriangleMesh& mesh,
                           const std::vector<uint32_t>& slotOf) {
  SimulatedSolver out = solver;
  for (size_t v = 0; v < solver.masses.size(); ++v) out.masses[slotOf[v]] = solver.masses[v];
  if (solver.stretchFactors.empty() && solver.bendFactors.empty()) return out;
  const Topology topology = buildIncidence(mesh);
  if (solver.model.stretch == StretchElement::EdgeSprings)
    out.stretchFactors = sortedFactors(solver.stretchFactors, topology, slotOf, false);
  out.bendFactors = sortedFactors(solver.bendFactors, topology, slotOf, true);
  return out;
}

}  // namespace limber
