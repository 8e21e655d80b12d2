#include "elastic/solid/lattice_mass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/triangle_mesh.h"

namespace limber {

namespace {

constexpr double kMoved = 1.0 / 12;  // of the mass of a cell
constexpr double kMin = 0.4,
                 kMax = 1.4;  // bounds on the mass of a node afterwards, relative to its mass before

// The corner of a cell on one side of an axis, with `lateral` as in Lattice::ends.
uint32_t cellCorner(uint32_t axis, uint32_t lateral, uint32_t side) {
  const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return side << axis | (lateral & 1) << u | (lateral >> 1) << v;
}

// The neighbours of each node along each axis, [6 * node + 2 * axis + side], or kNone. Where copies branch
// there may be several; the one of the first copy is used.
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

// Lumped masses that can be moved between neighbouring nodes.
class MovableMass {
 public:
  MovableMass(std::vector<double> mass, const Lattice& lattice)
      : mass_(std::move(mass)), before_(mass_), neighbours_(findNeighbours(lattice)) {}

  // Moves the mass `wanted` from a node to its neighbour in a direction (2 * axis + side). If the node has
  // too little, the rest is moved from that neighbour to the next one, which changes the moment by the same
  // amount. Nodes with hardly any mass get none, because they may have hardly any stiffness either.
  void moveInwards(uint32_t node, uint32_t direction, double wanted) {
    for (int attempt = 0; attempt < 2; ++attempt) {
      const uint32_t next = neighbours_[6 * size_t{node} + direction];
      if (next == kNone) return;
      const double available = mass_[node] - kMin * before_[node],
                   capacity = kMax * before_[next] - mass_[next];
      const double moved = std::max(0.0, std::min({wanted, available, capacity}));
      mass_[node] -= moved;
      mass_[next] += moved;
      wanted -= moved;
      node = next;
    }
  }

  std::vector<double> take() { return std::move(mass_); }

 private:
  std::vector<double> mass_, before_;
  std::vector<uint32_t> neighbours_;
};

}  // namespace

std::vector<double> latticeMass(const Lattice& lattice, const Hexahedron& brick) {
  std::vector<double> mass(lattice.nodeCount, 0);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy) {
    const auto part = brick.mass(lattice.filled[copy]);
    for (int k = 0; k < 8; ++k) mass[lattice.copyNodes[8 * copy + k]] += part[k];
  }
  const Vec3& size = lattice.grid.size;
  const double step = kMoved * size.x * size.y * size.z;
  MovableMass movable(std::move(mass), lattice);
  for (uint32_t copy = 0; copy < lattice.copyCount(); ++copy)
    for (uint32_t e = 0; e < 12; ++e) {
      const double end = lattice.ends[copy][e];
      const uint32_t axis = e / 4, side = end > 0 ? 1 : 0;
      const uint32_t outer = lattice.copyNodes[8 * copy + cellCorner(axis, e % 4, side)];
      movable.moveInwards(outer, 2 * axis + 1 - side, step * std::abs(end));
    }
  return movable.take();
}

}  // namespace limber
