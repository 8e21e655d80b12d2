#include "modes/lattice_mass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/triangle_mesh.h"

namespace limber {

namespace {

constexpr double kMoved = 1.0 / 12;    // of a cell's mass
constexpr double kLargestPart = 0.25;  // of a node's mass that moves at a time

// Corner of a cell on one side of an axis, `lateral` as in Lattice::ends.
uint32_t cornerAt(int axis, uint32_t lateral, uint32_t side) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  return side << axis | (lateral & 1) << u | (lateral >> 1) << v;
}

// The node next to each one along each axis, [6 * node + 2 * axis + side]; kNone where there is none. Where
// copies part there may be several: the one of the first copy.
std::vector<uint32_t> findNeighbours(const Lattice& lattice) {
  std::vector<uint32_t> neighbours(6 * size_t{lattice.nodeCount}, kNone);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy)
    for (uint32_t corner = 0; corner < 8; ++corner)
      for (uint32_t axis = 0; axis < 3; ++axis) {
        const uint32_t node = lattice.copyNodes[8 * copy + corner];
        uint32_t& next = neighbours[6 * size_t{node} + 2 * axis + (~corner >> axis & 1)];
        if (next == kNone) next = lattice.copyNodes[8 * copy + (corner ^ 1u << axis)];
      }
  return neighbours;
}

}  // namespace

std::vector<double> latticeMass(const Lattice& lattice, const Hexahedron& brick) {
  std::vector<double> mass(lattice.nodeCount, 0);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    const auto part = brick.mass(lattice.filled[copy]);
    for (int k = 0; k < 8; ++k) mass[lattice.copyNodes[8 * copy + k]] += part[k];
  }
  const Vec3& size = lattice.grid.size;
  const std::vector<uint32_t> neighbours = findNeighbours(lattice);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy)
    for (int axis = 0; axis < 3; ++axis)
      for (uint32_t lateral = 0; lateral < 4; ++lateral) {
        const double end = lattice.ends[copy][4 * axis + lateral];
        const uint32_t side = end > 0 ? 1 : 0;
        uint32_t outer = lattice.copyNodes[8 * copy + cornerAt(axis, lateral, side)];
        uint32_t inner = lattice.copyNodes[8 * copy + cornerAt(axis, lateral, 1 - side)];
        double wanted = kMoved * std::abs(end) * size.x * size.y * size.z;
        // What the end's node does not have moves one cell further inside: the moment is the same.
        for (int attempt = 0; attempt < 2 && inner != kNone; ++attempt) {
          const double part = std::min(wanted, kLargestPart * mass[outer]);
          mass[outer] -= part;
          mass[inner] += part;
          wanted -= part;
          outer = inner;
          inner = neighbours[6 * size_t{inner} + 2 * axis + (1 - side)];
        }
      }
  return mass;
}

}  // namespace limber
