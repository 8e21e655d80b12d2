#include "elastic/solid/lattice_mass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/triangle_mesh.h"

namespace limber {

namespace {

constexpr double kMoved = 1.0 / 12;          // of a cell's mass
constexpr double kLeast = 0.4, kMost = 1.4;  // what a node may have afterwards, of its mass before

// Corner of a cell on one side of an axis, `lateral` as in Lattice::ends.
uint32_t cellCorner(uint32_t axis, uint32_t lateral, uint32_t side) {
  const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
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

// Moves `wanted` from a node to the next one, and what cannot go there from that to the one behind: the
// moment is the same. No mass goes to where there is hardly any, for there may be no stiffness either.
void moveInwards(uint32_t node, uint32_t direction, double wanted, const std::vector<uint32_t>& neighbours,
                 const std::vector<double>& before, std::vector<double>& mass) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    const uint32_t next = neighbours[6 * size_t{node} + direction];
    if (next == kNone) return;
    const double spare = mass[node] - kLeast * before[node], room = kMost * before[next] - mass[next];
    const double part = std::max(0.0, std::min({wanted, spare, room}));
    mass[node] -= part;
    mass[next] += part;
    wanted -= part;
    node = next;
  }
}

}  // namespace

std::vector<double> latticeMass(const Lattice& lattice, const Hexahedron& brick) {
  std::vector<double> mass(lattice.nodeCount, 0);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    const auto part = brick.mass(lattice.filled[copy]);
    for (int k = 0; k < 8; ++k) mass[lattice.copyNodes[8 * copy + k]] += part[k];
  }
  const Vec3& size = lattice.grid.size;
  const double step = kMoved * size.x * size.y * size.z;
  const std::vector<double> before = mass;
  const std::vector<uint32_t> neighbours = findNeighbours(lattice);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy)
    for (uint32_t e = 0; e < 12; ++e) {
      const double end = lattice.ends[copy][e];
      const uint32_t axis = e / 4, side = end > 0 ? 1 : 0;
      const uint32_t outer = lattice.copyNodes[8 * copy + cellCorner(axis, e % 4, side)];
      moveInwards(outer, 2 * axis + 1 - side, step * std::abs(end), neighbours, before, mass);
    }
  return mass;
}

}  // namespace limber
