#include "simulate/contacts/self_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/topology.h"
#include "simulate/contacts/contact_surface.h"

namespace limber {

namespace {

// The most cells per axis, so that a key fits into 64 bits.
constexpr double kMostCells = 1 << 20;

using CellIndex = std::array<uint64_t, 3>;

uint64_t keyOf(const CellIndex& cell) {
  return (cell[2] << 42) | (cell[1] << 21) | cell[0];
}

// A grid that starts one cell below the lowest vertex, so that the indices of neighbouring cells are never
// negative.
struct Grid {
  Vec3 low;
  double cell;
  CellIndex cellOf(const Vec3& p) const {
    CellIndex index;
    for (int c = 0; c < 3; ++c)
      index[c] = 1 + static_cast<uint64_t>(std::min((p[c] - low[c]) / cell, kMostCells));
    return index;
  }
};

// The vertices of the triangles around v, ascending.
std::vector<uint32_t> ringOf(const TriangleMesh& mesh, const Topology& topology, uint32_t v) {
  std::vector<uint32_t> ring;
  for (const uint32_t t : topology.trianglesAround(v))
    ring.insert(ring.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::ranges::sort(ring);
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

}  // namespace

SelfContacts::SelfContacts(const TriangleMesh& mesh, double friction)
    : rest_(mesh.positions), friction_(static_cast<float>(friction)) {
  const Topology topology = buildTopology(mesh);
  for (const auto& edge : topology.edges)
    distance_ += length(rest_[edge.a] - rest_[edge.b]) / static_cast<double>(topology.edges.size());
  ringStart_.push_back(0);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto ring = ringOf(mesh, topology, v);
    rings_.insert(rings_.end(), ring.begin(), ring.end());
    ringStart_.push_back(static_cast<uint32_t>(rings_.size()));
  }
}

// Each ring has its own vertex, so that the rings of neighbours meet as well.
bool SelfContacts::areNear(uint32_t a, uint32_t b) const {
  auto shorter = ringAt(a), longer = ringAt(b);
  if (shorter.size() > longer.size()) std::swap(shorter, longer);
  return std::ranges::any_of(shorter, [&](uint32_t v) { return std::ranges::binary_search(longer, v); });
}

void SelfContacts::addPair(const Particles& particles, uint32_t a, uint32_t b, double searchDistance) {
  const double atRest = length(rest_[a] - rest_[b]), wa = particles.inverseMass[a],
               wb = particles.inverseMass[b];
  const Vec3 apart = particles.positions[a] - particles.positions[b];
  const double distance = std::min(distance_, atRest);
  if (wa + wb == 0 || !(squaredLength(apart) < (distance + searchDistance) * (distance + searchDistance)))
    return;
  if (areNear(a, b)) return;
  pairs_.push_back({a, b, toFloat4(apart), static_cast<float>(distance), static_cast<float>(wa / (wa + wb)),
                    static_cast<float>(wb / (wa + wb))});
}

void SelfContacts::rebase(const Particles& particles, int substeps) {
  float fastest = 0;
  Grid grid = {particles.positions[0], 0};
  for (uint32_t v = 0; v < particles.count(); ++v) {
    fastest = std::max(fastest, dot3(particles.motion[v].q, particles.motion[v].q));
    for (int c = 0; c < 3; ++c) grid.low[c] = std::min(grid.low[c], particles.positions[v][c]);
  }
  // Both vertices may move towards each other. The limit keeps cells small; faster vertices may pass through.
  const double searchDistance =
      std::min(2.0 * substeps * std::sqrt(double{fastest}) + 0.1 * distance_, distance_);
  grid.cell = distance_ + searchDistance;
  cells_.clear();
  for (uint32_t v = 0; v < particles.count(); ++v)
    cells_.push_back({keyOf(grid.cellOf(particles.positions[v])), v});
  std::sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) {
    return a.key != b.key ? a.key < b.key : a.vertex < b.vertex;
  });
  pairs_.clear();
  for (uint32_t v = 0; v < particles.count(); ++v) {
    const CellIndex at = grid.cellOf(particles.positions[v]);
    for (uint64_t z = at[2] - 1; z <= at[2] + 1; ++z)
      for (uint64_t y = at[1] - 1; y <= at[1] + 1; ++y) {
        const uint64_t first = keyOf({at[0] - 1, y, z});
        auto cell = std::lower_bound(cells_.begin(), cells_.end(), first,
                                     [](const Cell& a, uint64_t key) { return a.key < key; });
        for (; cell != cells_.end() && cell->key <= first + 2; ++cell)
          if (cell->vertex > v) addPair(particles, v, cell->vertex, searchDistance);
      }
  }
}

void SelfContacts::project(Particles& particles) const {
  for (const Pair& pair : pairs_) {
    Motion &a = particles.motion[pair.a], &b = particles.motion[pair.b];
    const Float4 apart = pair.base + ((a.u - b.u) + (a.q - b.q));
    const float squared = dot3(apart, apart);
    if (squared >= pair.distance * pair.distance || !(squared > 0)) continue;
    const float distance = std::sqrt(squared), depth = pair.distance - distance;
    const Float4 normal = apart / splat(distance);
    Float4 correction = normal * splat(depth);
    const Float4 relative = (a.q - b.q) + correction;
    correction -= frictionOf(relative, normal, friction_ * depth);
    a.q += correction * splat(pair.shareA);
    b.q -= correction * splat(pair.shareB);
  }
}

}  // namespace limber
