#include "simulate/lumped_masses.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace limber {

std::vector<double> lumpedMasses(const TriangleMesh& mesh, const Sheet& sheet,
                                 const SimulatedSolver* solver) {
  std::vector<double> masses(mesh.vertexCount(), 0.0);
  double sum = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const double third = sheet.surfaceDensity * triangleArea(mesh, t) / 3;
    for (const uint32_t v : mesh.triangles[t]) masses[v] += third;
    sum += 3 * third;
  }
  if (!(sum > 0) || !std::isfinite(sum))
    throw std::invalid_argument("The mesh has no area to simulate: give it triangles that are not flat.");
  if (solver && !solver->masses.empty()) return solver->masses;
  const bool isByVertex = solver && solver->model.mass == MassRule::Vertex;
  const double mean = sum / mesh.vertexCount();
  for (double& mass : masses) mass = isByVertex ? mean : std::max(mass, 1e-9 * mean);
  return masses;
}

}  // namespace limber
