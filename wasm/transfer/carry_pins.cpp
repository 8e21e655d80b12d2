#include "transfer/carry_pins.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mesh/pinned_vertices.h"
#include "mesh/sampling.h"
#include "mesh/topology.h"
#include "query/closest_point.h"
#include "query/surface_walk.h"

namespace limber {

namespace {

// A point with a barycentric coordinate above this is a vertex.
constexpr double kAtVertex = 1 - 1e-6;
// A vertex lies in the pinned region where the interpolated mask of the region has at least this value.
constexpr double kInside = 0.9;
// Whether a triangle lies in the region is tested at the centres of its kCuts^2 equal parts.
constexpr int kCuts = 4;

void check(const TriangleMesh& original, std::span<const uint32_t> pinned, const TriangleMesh& result) {
  if (std::ranges::any_of(pinned, [&](uint32_t v) { return v >= original.vertexCount(); }))
    throw std::invalid_argument("A pin names a vertex that the original does not have: give its own pins.");
  if (!pinned.empty() && result.triangles.empty())
    throw std::invalid_argument("A mesh without triangles cannot be pinned: give one that has some.");
}

// The triangles of a body whose corners are all pinned.
struct PinnedRegion {
  std::vector<uint8_t> hasVertex, hasTriangle;
  std::vector<uint32_t> componentOfVertex;  // of the region, not of the body
  bool isEmpty = true;
};

PinnedRegion pinnedRegion(const TriangleMesh& mesh, std::span<const uint32_t> pinned) {
  PinnedRegion region;
  std::vector<uint8_t> isPinned(mesh.vertexCount(), 0);
  for (const uint32_t v : pinned) isPinned[v] = 1;
  region.hasVertex.assign(mesh.vertexCount(), 0);
  region.hasTriangle.assign(mesh.triangleCount(), 0);
  TriangleMesh inside = {mesh.positions, {}};
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    if (!std::ranges::all_of(corners, [&](uint32_t v) { return isPinned[v] != 0; })) continue;
    region.hasTriangle[t] = 1;
    for (const uint32_t v : corners) region.hasVertex[v] = 1;
    inside.triangles.push_back(corners);
  }
  region.isEmpty = inside.triangles.empty();
  if (!region.isEmpty) region.componentOfVertex = buildTopology(inside).componentOfVertex;
  return region;
}

// For each triangle of the result the index of the nearest one, across edges and vertices, that has starts:
// its own if it has some itself, kNone if none of its part has.
std::vector<uint32_t> nearestWithStarts(const TriangleMesh& result,
                                        const std::vector<std::vector<uint32_t>>& starts) {
  const Topology topology = buildIncidence(result);
  std::vector<uint32_t> nearest(result.triangleCount(), kNone), queue;
  for (uint32_t t = 0; t < result.triangleCount(); ++t) {
    if (starts[t].empty()) continue;
    nearest[t] = t;
    queue.push_back(t);
  }
  for (size_t next = 0; next < queue.size(); ++next)
    for (const uint32_t v : result.triangles[queue[next]])
      for (const uint32_t t : topology.trianglesAround(v)) {
        if (nearest[t] != kNone) continue;
        nearest[t] = nearest[queue[next]];
        queue.push_back(t);
      }
  return nearest;
}

// Finds the points of the original that correspond to points of the result: on the sheet given by the
// binding, or the closest points overall.
class OriginalPoints {
 public:
  OriginalPoints(const TriangleMesh& original, const TriangleMesh& result,
                 std::span<const SurfacePoint> binding)
      : original_(original), tree_(original), starts_(binding.empty() ? 0 : result.triangleCount()) {
    if (binding.empty()) return;
    topology_ = buildTopology(original);
    walk_ = std::make_unique<SurfaceWalk>(original, topology_);
    for (uint32_t v = 0; v < original.vertexCount(); ++v)
      if (binding[v].triangle != kNone && !topology_.trianglesAround(v).empty())
        starts_[binding[v].triangle].push_back(topology_.trianglesAround(v)[0]);
    nearest_ = nearestWithStarts(result, starts_);
  }

  // For a point in a triangle of the result. If no vertex is bound to the triangle, the closest point overall
  // counts where it is on the part of the original that the nearest bound vertices belong to: another part
  // may touch this one.
  ClosestPoint find(const Vec3& point, uint32_t triangle) const {
    if (!walk_ || nearest_[triangle] == kNone) return tree_.closest(point);
    const std::vector<uint32_t>& starts = starts_[nearest_[triangle]];
    if (nearest_[triangle] != triangle) {
      const ClosestPoint closest = tree_.closest(point);
      if (componentOf(closest.triangle) == componentOf(starts[0])) return closest;
    }
    return walk_->closest(point, starts, [](uint32_t, uint32_t) { return true; });
  }

 private:
  uint32_t componentOf(uint32_t triangle) const {
    return topology_.componentOfVertex[original_.triangles[triangle][0]];
  }

  const TriangleMesh& original_;
  ClosestPointTree tree_;
  std::vector<std::vector<uint32_t>> starts_;  // per triangle of the result: triangles of the original
  std::vector<uint32_t> nearest_;  // per triangle of the result: the nearest one with starts, in its part
  Topology topology_;
  std::unique_ptr<SurfaceWalk> walk_;
};

// The bodies between which pins are carried over.
struct Bodies {
  const TriangleMesh& original;
  const TriangleMesh& result;
  std::span<const SurfacePoint> binding;
};

// Finds the vertices of the result that a pinned region of the original pins.
class RegionPins {
 public:
  RegionPins(const Bodies& bodies, const PinnedRegion& region)
      : original_(bodies.original),
        region_(region),
        result_(bodies.result),
        originalPoints_(bodies.original, bodies.result, bodies.binding),
        mask_(bodies.result.vertexCount(), -1),
        isPinned_(bodies.result.vertexCount(), 0),
        isComponentPinned_(bodies.original.vertexCount(), 0) {}

  // `isTouched`: per triangle of the result, whether a point of the region is bound to it.
  void find(const std::vector<uint8_t>& isTouched) {
    for (uint32_t t = 0; t < result_.triangleCount(); ++t)
      for (const uint32_t v : result_.triangles[t])
        if (mask_[v] < 0) mask_[v] = maskAt(originalPoints_.find(result_.positions[v], t));
    for (uint32_t v = 0; v < result_.vertexCount(); ++v) isPinned_[v] = mask_[v] >= kInside;
    for (uint32_t t = 0; t < result_.triangleCount(); ++t) {
      const Triangle& corners = result_.triangles[t];
      if (isTouched[t] || std::ranges::any_of(corners, [&](uint32_t v) { return mask_[v] > 0; }))
        pinTriangle(t);
    }
  }

  // Per vertex of the result.
  const std::vector<uint8_t>& isPinned() const { return isPinned_; }
  // Whether a triangle of the result is pinned because of the component of the region that contains vertex v
  // of the original.
  bool coversComponentOf(uint32_t v) const {
    return region_.hasVertex[v] && isComponentPinned_[region_.componentOfVertex[v]];
  }

 private:
  double maskAt(const SurfacePoint& point) const {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
      if (region_.hasVertex[original_.triangles[point.triangle][c]]) sum += point.barycentric[c];
    return sum;
  }

  // Pins the corners of a triangle of the result if more than half of it lies in the region.
  void pinTriangle(uint32_t t) {
    int inside = 0, all = 0;
    uint32_t component = kNone;
    const auto sample = [&](double b, double c) {
      const Vec3 point =
          result_.corner(t, 0) * (1 - b - c) + result_.corner(t, 1) * b + result_.corner(t, 2) * c;
      const uint32_t triangle = originalPoints_.find(point, t).triangle;
      ++all;
      if (!region_.hasTriangle[triangle]) return;
      ++inside;
      component = region_.componentOfVertex[original_.triangles[triangle][0]];
    };
    forEachPart(kCuts, [&](double u, double v) { sample(u / kCuts, v / kCuts); });
    if (2 * inside <= all) return;
    isComponentPinned_[component] = 1;
    for (const uint32_t v : result_.triangles[t]) isPinned_[v] = 1;
  }

  const TriangleMesh& original_;
  const PinnedRegion& region_;
  const TriangleMesh& result_;
  OriginalPoints originalPoints_;
  std::vector<double> mask_;  // per vertex of the result; negative while unknown
  std::vector<uint8_t> isPinned_;
  std::vector<uint8_t> isComponentPinned_;  // per component of the region
};

// For each pinned vertex its point on the result, with kNone as the triangle if it has none.
std::vector<SurfacePoint> resultPoints(const Bodies& bodies, std::span<const uint32_t> pinned) {
  std::vector<SurfacePoint> points;
  if (!bodies.binding.empty()) {
    for (const uint32_t v : pinned) points.push_back(bodies.binding[v]);
    return points;
  }
  const ClosestPointTree tree(bodies.result);
  const std::vector<Vec3> normals = vertexNormals(bodies.original);
  for (const uint32_t v : pinned)
    points.push_back(tree.closestFacing(bodies.original.positions[v], normals[v]));
  return points;
}

// Adds a point, or the vertex that it coincides with.
void addPoint(const SurfacePoint& point, const TriangleMesh& result, Pins& pins) {
  if (point.triangle == kNone) return;
  const double* const largest = std::max_element(point.barycentric, point.barycentric + 3);
  if (*largest > kAtVertex)
    pins.vertices.push_back(result.triangles[point.triangle][largest - point.barycentric]);
  else
    pins.points.push_back(point);
}

bool isSame(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.positions == b.positions;
}

bool comesBefore(const SurfacePoint& a, const SurfacePoint& b) {
  return a.triangle != b.triangle ? a.triangle < b.triangle
                                  : std::lexicographical_compare(a.barycentric, a.barycentric + 3,
                                                                 b.barycentric, b.barycentric + 3);
}

}  // namespace

Pins carryPins(const TriangleMesh& original, std::span<const uint32_t> pinned, const TriangleMesh& result,
               std::span<const SurfacePoint> binding) {
  check(original, pinned, result);
  if (isSame(original, result)) return {PinnedVertices({pinned.begin(), pinned.end()}).ids(), {}};
  Pins pins;
  const Bodies bodies{original, result, binding};
  const std::vector<SurfacePoint> points = resultPoints(bodies, pinned);
  const PinnedRegion region = pinnedRegion(original, pinned);
  std::vector<uint8_t> isCovered(pinned.size(), 0);
  if (!region.isEmpty) {
    std::vector<uint8_t> isTouched(result.triangleCount(), 0);
    for (size_t i = 0; i < pinned.size(); ++i)
      if (region.hasVertex[pinned[i]] && points[i].triangle != kNone) isTouched[points[i].triangle] = 1;
    RegionPins regionPins(bodies, region);
    regionPins.find(isTouched);
    for (uint32_t v = 0; v < result.vertexCount(); ++v)
      if (regionPins.isPinned()[v]) pins.vertices.push_back(v);
    for (size_t i = 0; i < pinned.size(); ++i) isCovered[i] = regionPins.coversComponentOf(pinned[i]);
  }
  for (size_t i = 0; i < pinned.size(); ++i)
    if (!isCovered[i]) addPoint(points[i], result, pins);
  pins.vertices = PinnedVertices(std::move(pins.vertices)).ids();
  std::sort(pins.points.begin(), pins.points.end(), comesBefore);
  return pins;
}

}  // namespace limber
