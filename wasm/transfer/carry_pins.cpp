#include "transfer/carry_pins.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "mesh/sampling.h"
#include "mesh/topology.h"
#include "query/closest_point.h"
#include "query/surface_walk.h"

namespace limber {

namespace {

// A barycentric coordinate this close to 1 is a vertex.
constexpr double kAtVertex = 1 - 1e-6;
// A vertex lies in the held part where the mask of its vertices has at least this value.
constexpr double kInside = 0.9;
// A triangle is looked at in the middles of the pieces that each edge cut into this many parts makes.
constexpr int kCuts = 4;

// The triangles of a body whose corners are all pinned.
struct HeldPart {
  std::vector<uint8_t> hasVertex, hasTriangle;
  std::vector<uint32_t> pieceOfVertex;  // numbers of its connected pieces
  bool isEmpty = true;
};

HeldPart heldPart(const TriangleMesh& mesh, std::span<const uint32_t> pinned) {
  HeldPart part;
  std::vector<uint8_t> isPinned(mesh.vertexCount(), 0);
  for (const uint32_t v : pinned) isPinned[v] = 1;
  part.hasVertex.assign(mesh.vertexCount(), 0);
  part.hasTriangle.assign(mesh.triangleCount(), 0);
  TriangleMesh held = {mesh.positions, {}};
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (!std::ranges::all_of(corners, [&](uint32_t v) { return isPinned[v] != 0; })) continue;
    part.hasTriangle[t] = 1;
    for (const uint32_t v : corners) part.hasVertex[v] = 1;
    held.triangles.push_back(corners);
  }
  part.isEmpty = held.triangles.empty();
  if (!part.isEmpty) part.pieceOfVertex = buildTopology(held).componentOfVertex;
  return part;
}

// Where points of `other` lie on the original: on the sheet that the binding says, or at the closest point.
class PlaceFinder {
 public:
  PlaceFinder(const TriangleMesh& original, const TriangleMesh& other, std::span<const SurfacePoint> binding)
      : tree_(original), startsOf_(binding.empty() ? 0 : other.triangleCount()) {
    if (binding.empty()) return;
    topology_ = buildTopology(original);
    walk_ = std::make_unique<SurfaceWalk>(original, topology_);
    for (uint32_t v = 0; v < original.vertexCount(); ++v)
      if (binding[v].triangle != kNone && !topology_.trianglesAround(v).empty())
        startsOf_[binding[v].triangle].push_back(topology_.trianglesAround(v)[0]);
  }

  // Of a point in a triangle of `other`.
  ClosestPoint find(const Vec3& point, uint32_t triangle) const {
    if (!walk_ || startsOf_[triangle].empty()) return tree_.closest(point);
    return walk_->closest(point, startsOf_[triangle], [](uint32_t, uint32_t) { return true; });
  }

 private:
  ClosestPointTree tree_;
  std::vector<std::vector<uint32_t>> startsOf_;  // per triangle of `other`: of the original
  Topology topology_;
  std::unique_ptr<SurfaceWalk> walk_;
};

// What of `other` a held part holds.
class HeldVertices {
 public:
  HeldVertices(const TriangleMesh& original, const HeldPart& part, const TriangleMesh& other,
               std::span<const SurfacePoint> binding)
      : original_(original),
        part_(part),
        other_(other),
        places_(original, other, binding),
        mask_(other.vertexCount(), -1),
        isHeld_(other.vertexCount(), 0),
        holdsPiece_(original.vertexCount(), 0) {}

  // `touched`: triangles that points of the part lie in.
  void find(const std::vector<uint8_t>& touched) {
    for (uint32_t t = 0; t < other_.triangleCount(); ++t)
      for (const uint32_t v : other_.triangles[t])
        if (mask_[v] < 0) mask_[v] = maskAt(places_.find(other_.positions[v], t));
    for (uint32_t v = 0; v < other_.vertexCount(); ++v) isHeld_[v] = mask_[v] >= kInside;
    for (uint32_t t = 0; t < other_.triangleCount(); ++t) {
      const Triangle& corners = other_.triangles[t];
      if (touched[t] || std::ranges::any_of(corners, [&](uint32_t v) { return mask_[v] > 0; })) lookAt(t);
    }
  }

  const std::vector<uint8_t>& isHeld() const { return isHeld_; }
  // Whether a triangle of `other` is held for the piece of the part that vertex v of the original belongs to.
  bool holdsPieceOf(uint32_t v) const { return part_.hasVertex[v] && holdsPiece_[part_.pieceOfVertex[v]]; }

 private:
  double maskAt(const ClosestPoint& place) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
      if (part_.hasVertex[original_.triangles[place.triangle][c]]) sum += place.barycentric[c];
    return sum;
  }

  void lookAt(uint32_t t) {
    int inside = 0, all = 0;
    uint32_t piece = kNone;
    const auto look = [&](double b, double c) {
      const Vec3 point =
          other_.corner(t, 0) * (1 - b - c) + other_.corner(t, 1) * b + other_.corner(t, 2) * c;
      const ClosestPoint place = places_.find(point, t);
      ++all;
      if (!part_.hasTriangle[place.triangle]) return;
      ++inside;
      piece = part_.pieceOfVertex[original_.triangles[place.triangle][0]];
    };
    forEachPart(kCuts, [&](double u, double v) { look(u / kCuts, v / kCuts); });
    if (2 * inside <= all) return;
    holdsPiece_[piece] = 1;
    for (const uint32_t v : other_.triangles[t]) isHeld_[v] = 1;
  }

  const TriangleMesh& original_;
  const HeldPart& part_;
  const TriangleMesh& other_;
  PlaceFinder places_;
  std::vector<double> mask_;  // per vertex of `other`; negative: not known yet
  std::vector<uint8_t> isHeld_;
  std::vector<uint8_t> holdsPiece_;  // by number of the piece
};

// Per pinned vertex its point on `other`; kNone as the triangle of those that have none.
std::vector<SurfacePoint> placesOn(const TriangleMesh& original, std::span<const uint32_t> pinned,
                                   const TriangleMesh& other, std::span<const SurfacePoint> binding) {
  std::vector<SurfacePoint> places;
  if (!binding.empty()) {
    for (const uint32_t v : pinned) places.push_back(binding[v]);
    return places;
  }
  const ClosestPointTree tree(other);
  const std::vector<Vec3> normals = vertexNormals(original);
  for (const uint32_t v : pinned) {
    const ClosestPoint point = tree.closestFacing(original.positions[v], normals[v]);
    places.push_back({point.triangle, {point.barycentric[0], point.barycentric[1], point.barycentric[2]}});
  }
  return places;
}

void addPlace(const SurfacePoint& place, const TriangleMesh& other, Pins& pins) {
  if (place.triangle == kNone) return;
  const double* const share = std::max_element(place.barycentric, place.barycentric + 3);
  if (*share > kAtVertex)
    pins.vertices.push_back(other.triangles[place.triangle][share - place.barycentric]);
  else
    pins.points.push_back(place);
}

bool comesBefore(const SurfacePoint& a, const SurfacePoint& b) {
  return a.triangle != b.triangle ? a.triangle < b.triangle
                                  : std::lexicographical_compare(a.barycentric, a.barycentric + 3,
                                                                 b.barycentric, b.barycentric + 3);
}

}  // namespace

Pins carryPins(const TriangleMesh& original, std::span<const uint32_t> pinned, const TriangleMesh& other,
               std::span<const SurfacePoint> binding) {
  Pins pins;
  const std::vector<SurfacePoint> places = placesOn(original, pinned, other, binding);
  const HeldPart part = heldPart(original, pinned);
  std::vector<uint8_t> isCovered(pinned.size(), 0);
  if (!part.isEmpty) {
    std::vector<uint8_t> touched(other.triangleCount(), 0);
    for (size_t i = 0; i < pinned.size(); ++i)
      if (part.hasVertex[pinned[i]] && places[i].triangle != kNone) touched[places[i].triangle] = 1;
    HeldVertices held(original, part, other, binding);
    held.find(touched);
    for (uint32_t v = 0; v < other.vertexCount(); ++v)
      if (held.isHeld()[v]) pins.vertices.push_back(v);
    for (size_t i = 0; i < pinned.size(); ++i) isCovered[i] = held.holdsPieceOf(pinned[i]);
  }
  for (size_t i = 0; i < pinned.size(); ++i)
    if (!isCovered[i]) addPlace(places[i], other, pins);
  std::sort(pins.vertices.begin(), pins.vertices.end());
  pins.vertices.erase(std::unique(pins.vertices.begin(), pins.vertices.end()), pins.vertices.end());
  std::sort(pins.points.begin(), pins.points.end(), comesBefore);
  return pins;
}

}  // namespace limber
