#include "modes/solid.h"

#include <algorithm>

#include "modes/element_assembly.h"
#include "modes/lattice.h"
#include "modes/lattice_mass.h"

namespace limber {

namespace {

// Stiffness that a cell has on top of its own, by that of a full cell: what is empty must not leave nodes
// loose, and mass must not hang on next to nothing where a piece is a sliver that hardly reaches its nodes.
// No mass comes with it. A strut of a tenth of a cell becomes stiffer by a tenth, one of a third by a
// hundredth.
constexpr double kEmptyStiffness = 1e-7, kStiffnessOfMass = 1e-3;
constexpr double kSliver = 0.5;  // filled up to this: the second kind is added

CellMeasure fullCell() {
  const auto along = lagrangeIntegrals(1);
  CellMeasure full;
  for (int q = 0; q < 27; ++q) full[q] = along[q % 3] * along[q / 3 % 3] * along[q / 9];
  return full;
}

StiffnessModel assemble(const Lattice& lattice, double poisson, Job& job) {
  StiffnessModel model;
  for (uint32_t node = 0; node <= lattice.nodeCount; ++node) model.firstUnknown.push_back(3 * node);
  const Hexahedron brick(lattice.grid.size, poisson);
  const CellMeasure full = fullCell();
  ElementAssembly assembly(model.firstUnknown, lattice.copyNodes, 8);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    if (copy % 256 == 0) job.check();
    CellMeasure held = lattice.filled[copy];
    const double fraction = filledFraction(held);
    const double added = kEmptyStiffness + (fraction < kSliver ? kStiffnessOfMass * fraction : 0);
    for (int q = 0; q < 27; ++q) held[q] += added * full[q];
    assembly.add(copy, brick.stiffness(held));
  }
  model.stiffness = assembly.take();
  const std::vector<double> mass = latticeMass(lattice, brick);
  model.mass.resize(3 * static_cast<Eigen::Index>(lattice.nodeCount));
  for (uint32_t node = 0; node < lattice.nodeCount; ++node)
    model.mass.segment<3>(3 * static_cast<Eigen::Index>(node)).setConstant(mass[node]);
  return model;
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

SolidModel solidModel(const TriangleMesh& body, const SolidOptions& options, Job& job) {
  const Lattice lattice = buildLattice(body, options.targetCells, job);
  SolidModel solid;
  solid.model = assemble(lattice, options.poisson, job);
  const Vec3& size = lattice.grid.size;
  solid.cellSize = std::max({size.x, size.y, size.z});
  embed(lattice, solid);
  return solid;
}

}  // namespace limber
