#include "elastic/solid/lattice.h"

#include <algorithm>

#include "base/parallel.h"
#include "elastic/solid/lattice_pieces.h"
#include "elastic/solid/lattice_slivers.h"
#include "mesh/topology.h"

namespace limber {

namespace {

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    volume += dot(mesh.corner(t, 0), cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6;
  return volume;
}

// Per sample: the integrals of the Lagrange polynomials over its part of the cell.
std::array<std::array<double, 3>, kSamples> integralsOfShares() {
  std::array<std::array<double, 3>, kSamples> shares;
  for (int s = 0; s < kSamples; ++s) {
    const auto begin = lagrangeIntegrals(double(s) / kSamples),
               end = lagrangeIntegrals(double(s + 1) / kSamples);
    for (int k = 0; k < 3; ++k) shares[s][k] = end[k] - begin[k];
  }
  return shares;
}

// The fraction of a cell's cross-section that one ray represents, times a linear weight that is 1 on one side
// of the cell (0: the low side) and 0 on the other.
double rayShare(int side, int sample) {
  const double position = (sample + 0.5) / kSamples;
  return (side ? position : 1 - position) / kSamples;
}

// A cell filled less than this contains only a side of the body that happens to coincide with cell faces.
constexpr double kHardly = 1e-3;

// The measure of a sliver replaces that of the lattice's rays if it is within these factors of it. Otherwise
// the piece has a fold or is thick, and its own rays measure it wrongly.
constexpr double kSliverLeast = 0.4, kSliverMost = 2.5;

class Builder {
 public:
  Builder(const TriangleMesh& body, const LatticeGrid& grid, Job& job)
      : body_(body),
        job_(job),
        surface_{lattice_.points, body.triangles, lattice_.grid, signedVolume(body) < 0 ? -1 : 1} {
    lattice_.grid = grid;
    lattice_.points = inLatticeUnits(body, lattice_.grid);
  }

  Lattice build() {
    families_.resize(3);
    parallelFor(4, 1, [&](size_t task, size_t) {
      if (task == 0)
        fragments_ = cutIntoFragments(surface_, job_);
      else
        families_[task - 1] = castRays(surface_, static_cast<int>(task) - 1, job_);
    });
    LatticePieces pieces(lattice_.grid, fragments_, families_);
    joinWithinCells(pieces);
    const uint32_t copyCount = pieces.copyCount();
    corners_ = DisjointSets(8 * size_t{copyCount});
    connected_ = DisjointSets(copyCount);
    lattice_.filled.resize(copyCount);
    lattice_.ends.resize(copyCount);
    segmentCount_.assign(copyCount, 0);
    crossedCount_.assign(copyCount, 0);
    joinThroughTriangles(pieces);
    for (const RayFamily& family : families_) followRays(pieces, family);
    measureSlivers(pieces);
    attachLooseCopies(pieces);
    lattice_.cells = pieces.cellsOfCopies();
    numberNodes(copyCount);
    assignVertices(pieces);
    return std::move(lattice_);
  }

 private:
  void joinWithinCells(LatticePieces& pieces) {
    const Topology topology = buildIncidence(body_);
    for (const Topology::Edge& edge : topology.edges)
      for (uint32_t use = 1; use < edge.useCount; ++use) {
        const uint32_t* triangle = &topology.edgeTriangles[edge.firstUse + use - 1];
        pieces.joinAlongEdge(triangle[0], triangle[1], lattice_.points[edge.a], lattice_.points[edge.b]);
      }
    joinAroundVertices(pieces);
    job_.check();
    for (const RayFamily& family : families_) pieces.joinAlongRays(family);
    job_.check();
    pieces.numberCopies();
  }

  // Also joins around vertices, because a component may be connected only at a vertex.
  void joinAroundVertices(LatticePieces& pieces) {
    std::vector<uint32_t> first(body_.vertexCount(), kNone);
    for (uint32_t t = 0; t < body_.triangleCount(); ++t)
      for (uint32_t v : body_.triangles[t]) {
        const uint32_t fragment = fragments_.find(t, lattice_.grid.cellOf(lattice_.points[v]));
        if (fragment == kNone) continue;
        if (first[v] == kNone) first[v] = fragment;
        pieces.joinFragments(first[v], fragment);
      }
  }

  // Lets `copy` share four nodes with `next`, its neighbour in the positive direction of the axis.
  void joinCopies(uint32_t copy, uint32_t next, int axis) {
    connected_.unite(copy, next);
    for (uint32_t corner = 0; corner < 8; ++corner)
      if (corner >> axis & 1) corners_.unite(8 * copy + corner, 8 * next + (corner ^ (1u << axis)));
  }

  void joinThroughTriangles(const LatticePieces& pieces) {
    for (uint32_t t = 0; t < body_.triangleCount(); ++t) {
      const uint32_t first = fragments_.start[t], last = fragments_.start[t + 1];
      for (uint32_t f = first; f + 1 < last; ++f)
        for (int axis = 0; axis < 3; ++axis) {
          if (lattice_.grid.positionOf(fragments_.cell[f])[axis] + 1 == lattice_.grid.count[axis]) continue;
          const uint32_t next = fragments_.find(t, fragments_.cell[f] + lattice_.grid.stride(axis));
          if (next != kNone) joinCopies(pieces.copyOfFragment(f), pieces.copyOfFragment(next), axis);
        }
    }
  }

  // Joins copies along the rays and measures how they are filled. The three families measure the same volume,
  // so each is weighted by a third.
  void followRays(const LatticePieces& pieces, const RayFamily& family) {
    static const auto shares = integralsOfShares();
    const int axis = family.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    constexpr int step[3] = {1, 3, 9};
    uint32_t before = kNone;
    pieces.forEachSegment(family, [&](const RaySegment& segment) {
      const uint32_t copy = pieces.copyOf(family, segment);
      if (!segment.isFirst && before != kNone && copy != kNone) joinCopies(before, copy, axis);
      before = copy;
      if (copy == kNone) return;
      ++segmentCount_[copy];
      if (segment.isFirst && segment.isLast) ++crossedCount_[copy];
      for (int lateral = 0; lateral < 4; ++lateral)
        lattice_.ends[copy][4 * axis + lateral] += (segment.isLast - segment.isFirst) *
                                                   rayShare(lateral & 1, segment.sample[u]) *
                                                   rayShare(lateral >> 1, segment.sample[v]);
      const auto begin = lagrangeIntegrals(segment.begin), end = lagrangeIntegrals(segment.end);
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i)
            lattice_.filled[copy][step[axis] * k + step[u] * i + step[v] * j] +=
                (end[k] - begin[k]) * shares[segment.sample[u]][i] * shares[segment.sample[v]][j] / 3;
    });
    job_.check();
  }

  // A piece is a sliver if few rays pass through it, or if many of them cross it from surface to surface in
  // one cell.
  bool isSliver(uint32_t copy) const {
    return segmentCount_[copy] <= kSamples * kSamples || 3 * crossedCount_[copy] >= segmentCount_[copy];
  }

  void measureSlivers(const LatticePieces& pieces) {
    std::vector<std::vector<uint32_t>> trianglesOf(pieces.copyCount());
    for (uint32_t t = 0; t < body_.triangleCount(); ++t)
      for (uint32_t f = fragments_.start[t]; f < fragments_.start[t + 1]; ++f)
        if (isSliver(pieces.copyOfFragment(f))) trianglesOf[pieces.copyOfFragment(f)].push_back(t);
    for (uint32_t copy = 0; copy < pieces.copyCount(); ++copy) {
      if (trianglesOf[copy].empty()) continue;
      job_.check();
      const CellMeasure measure =
          measureSliver({surface_, trianglesOf[copy], lattice_.grid.positionOf(pieces.cellOfCopy(copy)),
                         segmentCount_[copy] > 0});
      const double own = filledFraction(measure), common = filledFraction(lattice_.filled[copy]);
      if (common < kHardly || (own > kSliverLeast * common && own < kSliverMost * common))
        lattice_.filled[copy] = measure;
    }
  }

  // Merges copies that no ray connects to the rest into the fullest copy of their cell. They come from the
  // surfaces of cavities so small that they lie between the rays.
  void attachLooseCopies(const LatticePieces& pieces) {
    std::vector<uint64_t> segments(pieces.copyCount(), 0);
    for (uint32_t copy = 0; copy < pieces.copyCount(); ++copy)
      segments[connected_.rootOf(copy)] += segmentCount_[copy];
    const auto& cells = pieces.cellsOfCopies();
    std::vector<std::pair<uint32_t, uint32_t>> joints;
    for (uint32_t copy = 0; copy < pieces.copyCount(); ++copy) {
      if (segments[connected_.rootOf(copy)] > 0) continue;
      const auto [first, last] = std::equal_range(cells.begin(), cells.end(), cells[copy]);
      uint32_t fullest = copy;
      const auto end = static_cast<uint32_t>(last - cells.begin());
      for (auto c = static_cast<uint32_t>(first - cells.begin()); c < end; ++c)
        if (segmentCount_[c] > segmentCount_[fullest]) fullest = c;
      if (fullest != copy) joints.push_back({copy, fullest});
    }
    for (const auto& [copy, host] : joints) {
      for (uint32_t corner = 0; corner < 8; ++corner) corners_.unite(8 * copy + corner, 8 * host + corner);
      lattice_.filled[copy] = {};
    }
  }

  void numberNodes(uint32_t copyCount) {
    std::vector<uint32_t>& nodes = lattice_.copyNodes;
    nodes.assign(8 * size_t{copyCount}, kNone);
    for (uint32_t corner = 0; corner < nodes.size(); ++corner) {
      const uint32_t root = corners_.rootOf(corner);  // the smallest of its set, already visited
      nodes[corner] = root == corner ? lattice_.nodeCount++ : nodes[root];
    }
  }

  void assignVertices(const LatticePieces& pieces) {
    lattice_.copyOfVertex.assign(body_.vertexCount(), 0);
    for (uint32_t t = 0; t < body_.triangleCount(); ++t)
      for (uint32_t v : body_.triangles[t]) {
        const uint32_t fragment = fragments_.find(t, lattice_.grid.cellOf(lattice_.points[v]));
        if (fragment != kNone) lattice_.copyOfVertex[v] = pieces.copyOfFragment(fragment);
      }
  }

  const TriangleMesh& body_;
  Job& job_;
  Lattice lattice_;
  LatticeSurface surface_;  // refers to lattice_
  Fragments fragments_;
  std::vector<RayFamily> families_;
  DisjointSets corners_;                // [8 * copy + corner]: joined corners are one node
  DisjointSets connected_;              // joined copies are connected
  std::vector<uint32_t> segmentCount_;  // per copy: segments of rays through it
  std::vector<uint32_t> crossedCount_;  // per copy: those that begin and end within the cell
};

}  // namespace

Lattice buildLattice(const TriangleMesh& body, uint32_t targetCells, Job& job) {
  return Builder(body, latticeGrid(body, targetCells), job).build();
}

Lattice buildLattice(const TriangleMesh& body, const Vec3& cellSize, Job& job) {
  return Builder(body, latticeGrid(body, cellSize), job).build();
}

}  // namespace limber
