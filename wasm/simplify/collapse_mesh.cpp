#include "simplify/collapse_mesh.h"

#include <algorithm>
#include <cmath>

#include "simplify/sectors.h"

namespace limber {

CollapseMesh::CollapseMesh(const TriangleMesh& mesh, const Wishes& wishes)
    : livingTriangles_(mesh.triangleCount()) {
  const Topology topology = buildTopology(mesh);
  const Bounds box = bounds(mesh);
  diagonal_ = box.diagonal();
  // A sum as large as 2^52 steps has no digits below one step; the step is a power of two.
  if (diagonal_ > 0) rounder_ = std::ldexp(1.5, 52 - 30 + std::ilogb(diagonal_));
  for (int axis = 0; axis < 3; ++axis)
    origin_[axis] = static_cast<float>(0.5 * box.low[axis] + 0.5 * box.high[axis]);
  positions_ = mesh.positions;
  for (Vec3& p : positions_) p -= origin_;

  faces_.resize(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    faces_[t].vertices = mesh.triangles[t];
    std::copy_n(&topology.edgeOfCorner[3 * t], 3, faces_[t].edges.begin());
  }
  edges_.reserve(topology.edges.size());
  trianglesOnEdge_.reserve(topology.edges.size());
  for (const Topology::Edge& edge : topology.edges) {
    edges_.push_back({edge.a, edge.b});
    trianglesOnEdge_.push_back(static_cast<uint8_t>(std::min(edge.useCount, 3u)));
  }
  heirOf_.assign(edges_.size(), kNone);
  collectStars(mesh, topology);
  Lines lines = findLines(mesh, topology, wishes);
  if (!wishes.wedges.empty() || !wishes.attributes.empty()) {
    sectorOfCorner_ = findSectors(mesh, topology, lines);
    heirOfSector_.assign(sectorOfCorner_.empty() ? 0 : std::ranges::max(sectorOfCorner_) + 1, kNone);
  }
  isLine_ = std::move(lines.isLine);
  roles_ = std::move(lines.roles);
}

void CollapseMesh::collectStars(const TriangleMesh& mesh, const Topology& topology) {
  stars_.resize(mesh.vertexCount());
  pool_.reserve(4 * topology.vertexTriangles.size());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto around = topology.trianglesAround(v);
    const auto count = static_cast<uint32_t>(around.size());
    stars_[v] = {topology.vertexStart[v], count, count};
    for (uint32_t t : around) {
      const Triangle& triangle = mesh.triangles[t];
      pool_.push_back(4 * t + (triangle[1] == v ? 1 : triangle[2] == v ? 2 : 0));
    }
  }
}

bool CollapseMesh::isOn(const Face& face, uint32_t edge) const {
  return face.edges[0] == edge || face.edges[1] == edge || face.edges[2] == edge;
}

void CollapseMesh::removeFromStar(uint32_t v, uint32_t triangle) {
  Star& star = stars_[v];
  Corner* corners = pool_.data() + star.begin;
  const auto found =
      std::find_if(corners, corners + star.count, [&](Corner c) { return triangleOf(c) == triangle; });
  *found = corners[--star.count];
}

// The sector at the removed corner of a vanishing triangle joins that at the kept one.
void CollapseMesh::joinSectors(uint32_t triangle, int removed, int kept) {
  if (!sectorOfCorner_.empty()) heirOfSector_[sector(triangle, removed)] = sector(triangle, kept);
}

// Gives a corner of the removed vertex to the kept one, with the two edges that meet in it.
void CollapseMesh::takeOver(Corner corner, const Collapse& step) {
  Face& face = faces_[triangleOf(corner)];
  const int c = indexOf(corner);
  face.vertices[c] = step.kept;
  if (!sectorOfCorner_.empty()) {
    uint32_t& sector = sectorOfCorner_[3 * size_t{triangleOf(corner)} + c];
    sector = heirOfSector_[sector];
  }
  for (const int side : {nextIndex(c), previousIndex(c)}) {
    if (heirOf_[face.edges[side]] != kNone) face.edges[side] = heirOf_[face.edges[side]];
    Edge& edge = edges_[face.edges[side]];
    if (edge.a == step.removed) edge.a = step.kept;
    if (edge.b == step.removed) edge.b = step.kept;
  }
}

// Puts the joined star where the kept vertex's, or else the removed one's, has been, or in a new place with
// room to grow, so that many collapses into one vertex cost no more than their sum.
void CollapseMesh::storeStar(const std::vector<Corner>& joined, const Collapse& step) {
  const auto count = static_cast<uint32_t>(joined.size());
  Star& star = stars_[step.kept];
  Star& spare = stars_[step.removed];
  if (star.capacity < spare.capacity) std::swap(star, spare);
  if (count > star.capacity) {
    star = {static_cast<uint32_t>(pool_.size()), 0, count + count / 2};
    pool_.resize(pool_.size() + star.capacity);
  }
  std::copy(joined.begin(), joined.end(), pool_.begin() + star.begin);
  star.count = count;
  spare.count = 0;
}

Collapse CollapseMesh::collapseOf(uint32_t edge, const Vec3& target) const {
  const auto [a, b] = edges_[edge];
  const double toA = squaredLength(target - positions_[a]), toB = squaredLength(target - positions_[b]);
  const uint32_t fixed = fixedEnd(edge);
  const bool keepsA = fixed != kNone ? fixed == a : toA != toB ? toA < toB : a < b;
  return keepsA ? Collapse{edge, a, b, target} : Collapse{edge, b, a, target};
}

std::array<uint32_t, 2> CollapseMesh::collapse(const Collapse& step) {
  std::array<uint32_t, 2> gone{kNone, kNone};
  int goneCount = 0;
  joined_.clear();
  for (const Corner corner : star(step.kept)) {
    const Face& face = faces_[triangleOf(corner)];
    if (!isOn(face, step.edge)) {
      joined_.push_back(corner);
      continue;
    }
    // The triangle between kept, removed and a third vertex vanishes; its other two edges become one.
    const int c = indexOf(corner);
    const int third = face.edges[nextIndex(c)] == step.edge ? nextIndex(c) : previousIndex(c);
    const uint32_t heir = face.edges[3 - c - third], dying = face.edges[c];
    trianglesOnEdge_[heir] = static_cast<uint8_t>(trianglesOnEdge_[heir] + trianglesOnEdge_[dying] - 2);
    trianglesOnEdge_[dying] = 0;
    isLine_[heir] |= isLine_[dying];
    heirOf_[dying] = heir;
    gone[goneCount++] = dying;
    joinSectors(triangleOf(corner), 3 - c - third, c);
    removeFromStar(face.vertices[third], triangleOf(corner));
    --livingTriangles_;
  }
  trianglesOnEdge_[step.edge] = 0;
  for (const Corner corner : star(step.removed)) {
    if (isOn(faces_[triangleOf(corner)], step.edge)) continue;
    takeOver(corner, step);
    joined_.push_back(corner);
  }
  storeStar(joined_, step);
  positions_[step.kept] = step.target;
  return gone;
}

}  // namespace limber
