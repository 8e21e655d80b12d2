#include "simulate/contacts/self_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/topology.h"
#include "simulate/contacts/contact_surface.h"

namespace limber {

namespace {

// The limit on cells per axis that lets a key fit into 64 bits.
constexpr double kMaxCells = 1 << 20;
constexpr double kWidestSteps = 3;  // edges, limit on a diameter: touching vertices are at least as far apart

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
      index[c] = 1 + static_cast<uint64_t>(std::min((p[c] - low[c]) / cell, kMaxCells));
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

// The diameters of the balls; 0 at a vertex whose edges all have length 0. If vertices lie along a line with
// adjacent needles, as on the rim of a fan, the mean edge length is that of the needles, and a ball of that
// size would contain a number of vertices proportional to their total. Only vertices more than two edges
// apart touch, so the diameter is limited to three edges along the line, for which the longer of the two
// shortest edges is taken.
std::vector<double> ballWidths(const TriangleMesh& mesh, const Topology& topology) {
  struct Edges {
    double sum = 0, shortest = HUGE_VAL, second = HUGE_VAL;
    uint32_t count = 0;
  };
  std::vector<Edges> edges(mesh.vertexCount());
  for (const auto& edge : topology.edges) {
    const double size = length(mesh.positions[edge.a] - mesh.positions[edge.b]);
    for (const uint32_t v : {edge.a, edge.b}) {
      edges[v].sum += size;
      ++edges[v].count;
      edges[v].second = std::min(edges[v].second, std::max(size, edges[v].shortest));
      edges[v].shortest = std::min(edges[v].shortest, size);
    }
  }
  std::vector<double> widths;
  for (const Edges& at : edges)
    widths.push_back(at.count > 0 ? std::min(at.sum / at.count, kWidestSteps * at.second) : 0);
  return widths;
}

// How far beyond its ball a vertex of that diameter is searched. The limit keeps cells small; faster vertices
// may pass through.
double marginOf(double width, double travel) {
  return std::min(travel + 0.05 * width, width / 2);
}

// The cell size for which two vertices of at most this diameter that may touch lie in the same cell or in
// neighbouring ones.
double cellFor(double width, double travel) {
  return width + 2 * marginOf(width, travel);
}

}  // namespace

SelfContacts::SelfContacts(const TriangleMesh& mesh, double friction)
    : rest_(mesh.positions), friction_(static_cast<float>(friction)) {
  const Topology topology = buildTopology(mesh);
  width_ = ballWidths(mesh, topology);
  findLevels();
  ringStart_.push_back(0);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto ring = ringOf(mesh, topology, v);
    rings_.insert(rings_.end(), ring.begin(), ring.end());
    ringStart_.push_back(static_cast<uint32_t>(rings_.size()));
  }
}

// Diameters of one level differ by less than a factor of 2, so that the cells suit all of them.
void SelfContacts::findLevels() {
  std::map<int, Level> levelOfExponent;
  for (uint32_t v = 0; v < width_.size(); ++v) {
    if (!(width_[v] > 0)) continue;
    Level& level = levelOfExponent[std::ilogb(width_[v])];
    level.widest = std::max(level.widest, width_[v]);
    level.cells.push_back({0, v});
  }
  for (auto& [exponent, level] : levelOfExponent) levels_.push_back(std::move(level));
}

// Each ring includes its own vertex, so that the rings of neighbours intersect as well.
bool SelfContacts::areNear(uint32_t a, uint32_t b) const {
  auto shorter = ringAt(a), longer = ringAt(b);
  if (shorter.size() > longer.size()) std::swap(shorter, longer);
  return std::ranges::any_of(shorter, [&](uint32_t v) { return std::ranges::binary_search(longer, v); });
}

void SelfContacts::addPair(const Particles& particles, uint32_t a, uint32_t b, double travel) {
  if (a > b) std::swap(a, b);
  const double atRest = length(rest_[a] - rest_[b]), wa = particles.inverseMass[a],
               wb = particles.inverseMass[b];
  const Vec3 apart = particles.positions[a] - particles.positions[b];
  const double distance = std::min((width_[a] + width_[b]) / 2, atRest);
  const double farthest = distance + marginOf(width_[a], travel) + marginOf(width_[b], travel);
  if (wa + wb == 0 || !(squaredLength(apart) < farthest * farthest)) return;
  if (areNear(a, b)) return;
  pairs_.push_back({a, b, toFloat4(apart), static_cast<float>(distance), static_cast<float>(wa / (wa + wb)),
                    static_cast<float>(wb / (wa + wb))});
}

SelfContacts::Search SelfContacts::searchOf(const Particles& particles, int substeps) const {
  float fastest = 0;
  Vec3 low = particles.positions[0];
  for (uint32_t v = 0; v < particles.count(); ++v) {
    fastest = std::max(fastest, dot3(particles.motion[v].q, particles.motion[v].q));
    for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], particles.positions[v][c]);
  }
  return {low, substeps * std::sqrt(double{fastest})};
}

// Adds the pairs of a vertex of one level and a vertex of another, or of the same level.
void SelfContacts::findPairs(const Particles& particles, const Search& search, const Level& finer,
                             const Level& coarser) {
  const Grid grid = {search.low, cellFor(coarser.widest, search.travel)};
  for (const Cell& own : finer.cells) {
    const CellIndex at = grid.cellOf(particles.positions[own.vertex]);
    for (uint64_t z = at[2] - 1; z <= at[2] + 1; ++z)
      for (uint64_t y = at[1] - 1; y <= at[1] + 1; ++y) {
        const uint64_t first = keyOf({at[0] - 1, y, z});
        auto cell = std::ranges::lower_bound(coarser.cells, first, {}, &Cell::key);
        for (; cell != coarser.cells.end() && cell->key <= first + 2; ++cell)
          if (&finer != &coarser || cell->vertex > own.vertex)
            addPair(particles, own.vertex, cell->vertex, search.travel);
      }
  }
}

void SelfContacts::rebase(const Particles& particles, int substeps) {
  const Search search = searchOf(particles, substeps);
  for (Level& level : levels_) {
    const Grid grid = {search.low, cellFor(level.widest, search.travel)};
    for (Cell& cell : level.cells) cell.key = keyOf(grid.cellOf(particles.positions[cell.vertex]));
    std::ranges::sort(level.cells, {}, [](const Cell& cell) { return std::pair(cell.key, cell.vertex); });
  }
  pairs_.clear();
  for (size_t coarser = 0; coarser < levels_.size(); ++coarser)
    for (size_t finer = 0; finer <= coarser; ++finer)
      findPairs(particles, search, levels_[finer], levels_[coarser]);
  std::ranges::sort(pairs_, {}, [](const Pair& pair) { return std::pair(pair.a, pair.b); });
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
