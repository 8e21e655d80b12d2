#include "modes/lattice.h"

#include "mesh/topology.h"
#include "modes/lattice_pieces.h"

namespace limber {

namespace {

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    volume += dot(mesh.corner(t, 0), cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6;
  return volume;
}

// The integrals of the Lagrange polynomials over the share of the cell that each sample stands for.
std::array<std::array<double, 3>, kSamples> integralsOfShares() {
  std::array<std::array<double, 3>, kSamples> shares;
  for (int s = 0; s < kSamples; ++s) {
    const auto begin = lagrangeIntegrals(double(s) / kSamples),
               end = lagrangeIntegrals(double(s + 1) / kSamples);
    for (int k = 0; k < 3; ++k) shares[s][k] = end[k] - begin[k];
  }
  return shares;
}

class Builder {
 public:
  Builder(const TriangleMesh& body, uint32_t targetCells, Job& job) : body_(body), job_(job) {
    lattice_.grid = latticeGrid(body, targetCells);
    lattice_.points = inLatticeUnits(body, lattice_.grid);
  }

  Lattice build() {
    fragments_ = cutIntoFragments(lattice_.points, body_.triangles, lattice_.grid, job_);
    const int sign = signedVolume(body_) < 0 ? -1 : 1;
    for (int axis = 0; axis < 3; ++axis)
      families_.push_back(castRays(lattice_.points, body_.triangles, lattice_.grid, axis, sign, job_));
    LatticePieces pieces(lattice_.grid, fragments_, families_);
    joinWithinCells(pieces);
    corners_.reset(8 * size_t{pieces.copyCount()});
    lattice_.filled.resize(pieces.copyCount());
    joinThroughTriangles(pieces);
    for (const RayFamily& family : families_) followRays(pieces, family);
    numberNodes(pieces.copyCount());
    placeVertices(pieces);
    return std::move(lattice_);
  }

 private:
  void joinWithinCells(LatticePieces& pieces) {
    const Topology topology = buildTopology(body_);
    for (const Topology::Edge& edge : topology.edges)
      for (uint32_t use = 1; use < edge.useCount; ++use) {
        const uint32_t* triangle = &topology.edgeTriangles[edge.firstUse + use - 1];
        pieces.joinAlongEdge(triangle[0], triangle[1], lattice_.points[edge.a], lattice_.points[edge.b]);
      }
    job_.check();
    for (const RayFamily& family : families_) pieces.joinAlongRays(family);
    job_.check();
    pieces.numberCopies();
  }

  // `next` lies beyond `copy` along the axis: they share the four nodes between them.
  void joinCopies(uint32_t copy, uint32_t next, int axis) {
    for (uint32_t corner = 0; corner < 8; ++corner)
      if (corner >> axis & 1) corners_.join(8 * copy + corner, 8 * next + (corner ^ (1u << axis)));
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

  // Joins copies along the rays and measures how they are filled. The three families measure the same inside:
  // the mean of them is taken.
  void followRays(const LatticePieces& pieces, const RayFamily& family) {
    static const auto shares = integralsOfShares();
    const int axis = family.axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    constexpr int step[3] = {1, 3, 9};
    uint32_t before = kNone;
    pieces.forEachStretch(family, [&](const Stretch& stretch) {
      const uint32_t copy = pieces.copyOf(family, stretch);
      if (!stretch.isFirst && before != kNone && copy != kNone) joinCopies(before, copy, axis);
      before = copy;
      if (copy == kNone) return;
      const auto begin = lagrangeIntegrals(stretch.begin), end = lagrangeIntegrals(stretch.end);
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i)
            lattice_.filled[copy][step[axis] * k + step[u] * i + step[v] * j] +=
                (end[k] - begin[k]) * shares[stretch.sample[u]][i] * shares[stretch.sample[v]][j] / 3;
    });
    job_.check();
  }

  void numberNodes(uint32_t copyCount) {
    std::vector<uint32_t>& nodes = lattice_.copyNodes;
    nodes.assign(8 * size_t{copyCount}, kNone);
    for (uint32_t corner = 0; corner < nodes.size(); ++corner) {
      const uint32_t root = corners_.find(corner);  // the smallest of its set: it was seen before
      nodes[corner] = root == corner ? lattice_.nodeCount++ : nodes[root];
    }
  }

  void placeVertices(const LatticePieces& pieces) {
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
  Fragments fragments_;
  std::vector<RayFamily> families_;
  DisjointSets corners_;
};

}  // namespace

Lattice buildLattice(const TriangleMesh& body, uint32_t targetCells, Job& job) {
  return Builder(body, targetCells, job).build();
}

}  // namespace limber
