#include "elastic/solid/solid.h"

#include <algorithm>

#include "elastic/solid/lattice.h"
#include "elastic/solid/lattice_mass.h"
#include "linear/element_assembly.h"

namespace limber {

namespace {

// Stiffness without mass that is added to a cell, relative to a full cell. The first kind is added to every
// cell, so that no node in empty parts is without stiffness. The second is added to cells filled up to
// kSliver, times their filled fraction, so that a sliver is stiff enough for its mass. It makes a strut of a
// tenth of a cell stiffer by a tenth, one of a third by a hundredth.
constexpr double kEmptyStiffness = 1e-7, kStiffnessOfMass = 1e-3;
constexpr double kSliver = 0.5;
constexpr uint32_t kCheckInterval = 256;  // cells between two checks for cancellation

CellMeasure fullCell() {
  const auto along = lagrangeIntegrals(1);
  CellMeasure full;
  for (int q = 0; q < 27; ++q) full[q] = along[q % 3] * along[q / 3 % 3] * along[q / 9];
  return full;
}

// The mass of a node lighter than this, relative to the heaviest node of its cells, is distributed to all
// others: the node belongs to a sliver at the rim of the body, which follows its neighbours and must not
// vibrate on its own.
constexpr double kLightest = 0.01;

void dropLightMasses(const Lattice& lattice, std::vector<double>& mass) {
  std::vector<double> heaviest(mass.size(), 0.0);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    const uint32_t* nodes = &lattice.copyNodes[8 * size_t{copy}];
    double most = 0;
    for (int k = 0; k < 8; ++k) most = std::max(most, mass[nodes[k]]);
    for (int k = 0; k < 8; ++k) heaviest[nodes[k]] = std::max(heaviest[nodes[k]], most);
  }
  double before = 0, after = 0;
  for (size_t node = 0; node < mass.size(); ++node) {
    before += mass[node];
    if (mass[node] < kLightest * heaviest[node]) mass[node] = 0;
    after += mass[node];
  }
  if (after > 0)
    for (double& value : mass) value *= before / after;
}

SparsePencil assemble(const Lattice& lattice, double poisson, Job& job) {
  SparsePencil pencil;
  for (uint32_t node = 0; node <= lattice.nodeCount; ++node) pencil.firstUnknown.push_back(3 * node);
  const Hexahedron brick(lattice.grid.size, poisson);
  ElementAssembly assembly(pencil.firstUnknown, lattice.copyNodes, 8);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    if (copy % kCheckInterval == 0) job.check();
    assembly.add(copy, brick.stiffness(stiffnessMeasure(lattice.filled[copy])));
  }
  assembly.take(pencil.k);
  std::vector<double> mass = latticeMass(lattice, brick);
  dropLightMasses(lattice, mass);
  pencil.m.resize(3 * static_cast<Eigen::Index>(lattice.nodeCount));
  for (uint32_t node = 0; node < lattice.nodeCount; ++node)
    pencil.m.segment<3>(3 * static_cast<Eigen::Index>(node)).setConstant(mass[node]);
  return pencil;
}

void embed(const Lattice& lattice, SolidModel& solid) {
  for (size_t v = 0; v < lattice.points.size(); ++v) {
    const uint32_t copy = lattice.copyOfVertex[v];
    const Vec3& p = lattice.points[v];
    Vec3 local;
    for (int axis = 0; axis < 3; ++axis) local[axis] = p[axis] - lattice.grid.along(axis, p[axis]);
    const auto weights = trilinearWeights(local);
    solid.embeddingWeights.insert(solid.embeddingWeights.end(), weights.begin(), weights.end());
    const auto first = lattice.copyNodes.begin() + 8 * static_cast<std::ptrdiff_t>(copy);
    solid.embeddingNodes.insert(solid.embeddingNodes.end(), first, first + 8);
  }
}

}  // namespace

CellMeasure stiffnessMeasure(const CellMeasure& filled) {
  static const CellMeasure full = fullCell();
  const double fraction = filledFraction(filled);
  const double added = kEmptyStiffness + (fraction < kSliver ? kStiffnessOfMass * fraction : 0);
  CellMeasure measure = filled;
  for (int q = 0; q < 27; ++q) measure[q] += added * full[q];
  return measure;
}

SolidModel solidModel(const TriangleMesh& body, const SolidOptions& options, Job& job) {
  const Lattice lattice = buildLattice(body, options.targetCells, job);
  SolidModel solid;
  solid.pencil = assemble(lattice, options.poisson, job);
  const Vec3& size = lattice.grid.size;
  solid.cellSize = std::max({size.x, size.y, size.z});
  embed(lattice, solid);
  return solid;
}

}  // namespace limber
