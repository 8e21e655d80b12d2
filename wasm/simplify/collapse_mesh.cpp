#include "simplify/collapse_mesh.h"

#include <algorithm>
#include <cmath>

#include "simplify/sectors.h"

namespace limber {
namespace {

// Of the squared length of a feature edge, for the planes through it (see OptimumFinder): larger values keep
// feature edges straighter and weigh the adjacent surface less.
constexpr double kFeatureWeight = 10;

}  // namespace

CollapseMesh::CollapseMesh(const TriangleMesh& mesh, const SimplifyConstraints& constraints)
    : livingTriangles_(mesh.triangleCount()) {
  const Topology topology = buildIncidence(mesh);
  const Bounds box = bounds(mesh);
  diagonal_ = box.diagonal();
  // Doubles from 2^52 steps on have no digits below one step; the step is a power of two.
  if (diagonal_ > 0) rounder_ = std::ldexp(1.5, 52 - 30 + std::ilogb(diagonal_));
  for (int axis = 0; axis < 3; ++axis)
    origin_[axis] = static_cast<float>(0.5 * box.low[axis] + 0.5 * box.high[axis]);
  faces_.resize(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    faces_[t].vertices = mesh.triangles[t];
    std::copy_n(&topology.edgeOfCorner[3 * t], 3, faces_[t].edges.begin());
  }
  const FeatureEdges features = findFeatureEdges(mesh, topology, constraints);
  collectVertices(mesh, topology, features);
  if (!constraints.wedges.empty() || !constraints.attributes.empty()) {
    sectorOfCorner_ = findSectors(mesh, topology, features);
    heirOfSector_.assign(sectorOfCorner_.empty() ? 0 : std::ranges::max(sectorOfCorner_) + 1, kNone);
  }
  edges_.reserve(topology.edges.size());
  for (const Topology::Edge& edge : topology.edges)
    edges_.push_back({.ends = {edge.a, edge.b},
                      .heir = kNone,
                      .triangles = static_cast<uint8_t>(std::min(edge.useCount, 3u)),
                      .feature = features.kinds[edges_.size()]});
  collectQuadrics(constraints.textureWeights);
}

void CollapseMesh::collectVertices(const TriangleMesh& mesh, const Topology& topology,
                                   const FeatureEdges& features) {
  vertices_.reserve(mesh.vertexCount());
  pool_.reserve(4 * topology.vertexCorners.size() + mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto corners = topology.cornersAt(v);
    const auto count = static_cast<uint32_t>(corners.size());
    pool_.push_back(Corner::fromCode(count));
    vertices_.push_back({.position = mesh.positions[v] - origin_,
                         .star = {static_cast<uint32_t>(pool_.size()), count},
                         .role = features.roles[v]});
    for (const Corner corner : corners) pool_.push_back(corner);
  }
}

void CollapseMesh::collectQuadrics(std::span<const float> textureWeights) {
  for (size_t t = 0; t < faces_.size(); ++t) {
    const auto& [corners, edges] = faces_[t];
    const Vec3 &p = position(corners[0]), &q = position(corners[1]), &r = position(corners[2]);
    const Vec3 areaNormal = cross(q - p, r - p);
    const double twiceArea = length(areaNormal);
    // Equals area n n^T for the unit normal n, with one root and one division.
    Quadric plane = planeQuadric(areaNormal, p, twiceArea > 0 ? 0.5 / twiceArea : 0);
    plane.area = 0.5 * twiceArea;
    for (const uint32_t v : corners) vertices_[v].quadric = vertices_[v].quadric + plane;
    // A sliding texture costs as much as a deviation of the triangle by the same distance, apart from sliding
    // that is invisible.
    const double slide = plane.area * (textureWeights.empty() ? 1 : textureWeights[t]);
    for (int c = 0; c < 3; ++c) {
      if (!isFeature(edges[c])) continue;
      const uint32_t from = corners[nextIndex(c)], to = corners[previousIndex(c)];
      const Vec3 along = position(to) - position(from);
      const Quadric across =
          planeQuadric(normalized(cross(along, areaNormal)), position(from), featureWeight(edges[c], slide));
      for (const uint32_t v : {from, to}) vertices_[v].quadric = vertices_[v].quadric + across;
    }
  }
}

// The weight of the plane perpendicular to a triangle on its feature edge. Any motion of an outline is
// visible; that of a seam only as far as the texture slides, with the weight `slide`.
double CollapseMesh::featureWeight(uint32_t edge, double slide) const {
  if (edges_[edge].triangles == 2 && edges_[edge].feature == FeatureKind::Seam) return slide;
  const auto [a, b] = edges_[edge].ends;
  return kFeatureWeight * squaredLength(position(b) - position(a));
}

bool CollapseMesh::isOn(const Face& face, uint32_t edge) const {
  return (face.edges[0] == edge) + (face.edges[1] == edge) + (face.edges[2] == edge) > 0;
}

void CollapseMesh::removeFromStar(uint32_t v, uint32_t triangle) {
  Star& star = vertices_[v].star;
  Corner* corners = pool_.data() + star.begin;
  const auto found =
      std::find_if(corners, corners + star.count, [&](Corner c) { return c.triangle() == triangle; });
  *found = corners[--star.count];
}

// The sector at the removed corner of a vanishing triangle becomes part of that at the kept corner.
void CollapseMesh::joinSectors(Corner removed, Corner kept) {
  if (!sectorOfCorner_.empty()) heirOfSector_[sector(removed)] = sector(kept);
}

// Merges an edge into its heir after the triangle between them has vanished.
void CollapseMesh::mergeEdges(uint32_t dying, uint32_t heir) {
  Edge &from = edges_[dying], &to = edges_[heir];
  to.triangles = static_cast<uint8_t>(to.triangles + from.triangles - 2);
  to.feature = std::max(to.feature, from.feature);
  from.triangles = 0;
  from.heir = heir;
}

// Transfers a corner of the removed vertex to the kept one, with the two edges that meet in it.
void CollapseMesh::transferCorner(Corner corner, const Collapse& step) {
  Face& face = faces_[corner.triangle()];
  const int c = corner.index();
  face.vertices[c] = step.kept;
  if (!sectorOfCorner_.empty()) {
    uint32_t& sector = sectorOfCorner_[corner.flatIndex()];
    sector = heirOfSector_[sector];
  }
  for (const int side : {nextIndex(c), previousIndex(c)}) {
    uint32_t& edge = face.edges[side];
    const uint32_t heir = edges_[edge].heir;
    edge = heir != kNone ? heir : edge;
    Ends& ends = edges_[edge].ends;
    ends = {ends.a == step.removed ? step.kept : ends.a, ends.b == step.removed ? step.kept : ends.b};
  }
}

// Stores the joined star in the memory of the kept or the removed vertex, whichever is larger, or in new
// memory with spare capacity, so that the cost of many collapses into one vertex is amortised.
void CollapseMesh::storeStar(const Collapse& step) {
  const auto count = static_cast<uint32_t>(change_.count);
  Star& star = vertices_[step.kept].star;
  Star& spare = vertices_[step.removed].star;
  if (capacityOf(star) < capacityOf(spare)) std::swap(star, spare);
  if (count > capacityOf(star)) {
    star.begin = static_cast<uint32_t>(pool_.size()) + 1;
    pool_.resize(star.begin + count + count / 2);
    pool_[star.begin - 1] = Corner::fromCode(count + count / 2);
  }
  std::copy_n(change_.corners.begin(), count, pool_.begin() + star.begin);
  star.count = count;
  spare.count = 0;
}

Collapse CollapseMesh::collapseOf(uint32_t edge, const Vec3& target) const {
  const auto [a, b] = edges_[edge].ends;
  const double toA = squaredLength(target - position(a)), toB = squaredLength(target - position(b));
  const uint32_t fixed = fixedEnd(edge);
  const bool keepsA = fixed != kNone ? fixed == a : toA != toB ? toA < toB : a < b;
  return keepsA ? Collapse{edge, a, b, target} : Collapse{edge, b, a, target};
}

// Appends the corners at v to those of `change_`, except those of the at most two triangles on its edge,
// which go to `vanishing`. Calls visit with the mark of each neighbour. Branch-free, because branches would
// be unpredictable.
template <class Visit>
size_t CollapseMesh::divideStar(uint32_t v, size_t count, std::array<Corner, 3>& vanishing,
                                const Visit& visit) {
  const auto corners = star(v);
  auto& staying = change_.corners;
  if (staying.size() <= count + corners.size()) staying.resize(2 * (count + corners.size() + 1));
  // In a closed fan every neighbour follows v in one of the triangles.
  const bool open = role(v).onBorder;
  size_t found = 0;
  for (const Corner corner : corners) {
    const Face& face = faces_[corner.triangle()];
    visit(vertices_[face.vertices[nextIndex(corner.index())]].seen);
    if (open) visit(vertices_[face.vertices[previousIndex(corner.index())]].seen);
    const bool vanishes = isOn(face, change_.edge);
    staying[count] = vanishing[found] = corner;
    count += !vanishes;
    found += vanishes;
  }
  return count;
}

const CollapseMesh::Change& CollapseMesh::changeOf(const Collapse& step) {
  if (change_.edge == step.edge && change_.kept == step.kept) return change_;
  change_.edge = step.edge;
  change_.kept = step.kept;
  const uint32_t around = ++mark_, common = ++mark_;
  uint32_t shared = 0;
  std::array<Corner, 3> others;
  change_.ofKept = divideStar(step.kept, 0, change_.vanishing, [&](uint32_t& seen) { seen = around; });
  change_.count = divideStar(step.removed, change_.ofKept, others, [&](uint32_t& seen) {
    shared += seen == around;
    seen = seen == around ? common : seen;
  });
  change_.commonNeighbours = shared;
  return change_;
}

std::array<uint32_t, 2> CollapseMesh::collapse(const Collapse& step) {
  std::array<uint32_t, 2> gone{kNone, kNone};
  const int goneCount = edges_[step.edge].triangles;
  changeOf(step);
  for (int i = 0; i < goneCount; ++i) {
    // The triangle between kept, removed and a third vertex vanishes; its other two edges become one.
    const Corner corner = change_.vanishing[i];
    const Face& face = faces_[corner.triangle()];
    const int c = corner.index();
    const int third = face.edges[nextIndex(c)] == step.edge ? nextIndex(c) : previousIndex(c);
    gone[i] = face.edges[c];
    mergeEdges(gone[i], face.edges[3 - c - third]);
    joinSectors(Corner(corner.triangle(), 3 - c - third), corner);
    removeFromStar(face.vertices[third], corner.triangle());
    --livingTriangles_;
  }
  edges_[step.edge].triangles = 0;
  for (size_t i = change_.ofKept; i < change_.count; ++i) transferCorner(change_.corners[i], step);
  storeStar(step);
  change_.edge = kNone;
  Vertex& kept = vertices_[step.kept];
  kept.position = step.target;
  kept.quadric = kept.quadric + vertices_[step.removed].quadric;
  return gone;
}

}  // namespace limber
