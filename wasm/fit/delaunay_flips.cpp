#include "fit/delaunay_flips.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/parallel.h"
#include "mesh/edge_flip.h"
#include "mesh/quality.h"
#include "mesh/topology.h"

namespace limber {

namespace {

constexpr int kMaxPasses = 12;  // over all edges
constexpr size_t kEdgesPerRange = 8192;
constexpr double kFlat = 0.97;     // smallest cosine between any old and any new normal
constexpr double kClearly = 1e-3;  // the sine of the sum of both opposite angles must be less than minus this

// The distance between the straight lines through both diagonals of the quad.
double liftOf(const Vec3& start, const Vec3& end, const Vec3& left, const Vec3& right) {
  const Vec3 across = cross(end - start, right - left);
  const double size = length(across);
  return size > 0 ? std::abs(dot(across, left - start)) / size : 0;
}

class Flipping {
 public:
  Flipping(TriangleMesh& mesh, const FlipLimits& limits, std::vector<uint32_t>& corners)
      : mesh_(mesh), limits_(limits), corners_(corners), isOpen_(mesh.triangleCount(), 1) {}

  uint32_t pass() {
    topology_ = buildIncidence(mesh_);
    wasOpen_.assign(mesh_.triangleCount(), 0);
    wasOpen_.swap(isOpen_);
    triangleChanged_.assign(mesh_.triangleCount(), 0);
    vertexChanged_.assign(mesh_.vertexCount(), 0);
    const std::vector<uint8_t> isWorse = edgesToLookAt();
    uint32_t flips = 0;
    for (size_t e = 0; e < isWorse.size(); ++e)
      if (isWorse[e]) flips += tryFlip(topology_.edges[e]);
    return flips;
  }

 private:
  std::vector<uint8_t> edgesToLookAt() const;
  uint32_t tryFlip(const Topology::Edge& edge);
  std::optional<EdgeQuad> wantedQuad(const Topology::Edge& edge);
  std::optional<EdgeQuad> imageOf(const EdgeQuad& quad);
  void leaveOpen(const EdgeQuad& quad) { isOpen_[quad.first] = isOpen_[quad.second] = 1; }
  bool exists(uint32_t a, uint32_t b) const;
  bool isDelaunay(uint32_t start, uint32_t end, uint32_t left, uint32_t right) const;
  void flip(const EdgeQuad& quad);

  TriangleMesh& mesh_;
  FlipLimits limits_;
  std::vector<uint32_t>& corners_;
  Topology topology_;
  std::vector<uint8_t> triangleChanged_, vertexChanged_;  // in this pass
  // Per triangle whether the next pass has to test its edges, because it has changed or because a temporary
  // obstacle prevented the flip of one of them; and the same from the previous pass.
  std::vector<uint8_t> isOpen_, wasOpen_;
};

// Whether cot(a) + cot(b) >= 0, up to rounding, for the angles a and b opposite to the edge.
bool Flipping::isDelaunay(uint32_t start, uint32_t end, uint32_t left, uint32_t right) const {
  const auto& at = mesh_.positions;
  const Vec3 p = at[start] - at[left], q = at[end] - at[left];
  const Vec3 r = at[start] - at[right], s = at[end] - at[right];
  const double sineOfSum = length(cross(p, q)) * dot(r, s) + dot(p, q) * length(cross(r, s));
  return sineOfSum >= -kClearly * length(p) * length(q) * length(r) * length(s);
}

bool Flipping::exists(uint32_t a, uint32_t b) const {
  return std::ranges::any_of(topology_.trianglesAround(a),
                             [&](uint32_t t) { return std::ranges::count(mesh_.triangles[t], b) > 0; });
}

// Per edge whether it belongs to an open triangle and is not Delaunay at the start of this pass. The others
// are skipped: a flip next to one of them leaves its triangle open for the next pass.
std::vector<uint8_t> Flipping::edgesToLookAt() const {
  std::vector<uint8_t> isWorse(topology_.edges.size(), 0);
  parallelFor(isWorse.size(), kEdgesPerRange, [&](size_t begin, size_t end) {
    for (size_t e = begin; e < end; ++e) {
      const Topology::Edge& edge = topology_.edges[e];
      if (std::ranges::none_of(topology_.trianglesAt(edge), [&](uint32_t t) { return wasOpen_[t]; }))
        continue;
      const std::optional<EdgeQuad> quad = quadAt(mesh_, topology_, edge);
      isWorse[e] = quad && !isDelaunay(quad->start, quad->end, quad->left, quad->right);
    }
  });
  return isWorse;
}

// The two triangles of an edge that should be flipped and can be.
std::optional<EdgeQuad> Flipping::wantedQuad(const Topology::Edge& edge) {
  if (std::ranges::binary_search(limits_.fixed, std::array{edge.a, edge.b})) return std::nullopt;
  const std::optional<EdgeQuad> quad = quadAt(mesh_, topology_, edge);
  if (!quad) return std::nullopt;
  const auto [first, second, firstTip, secondTip, left, start, end, right] = *quad;
  if (triangleChanged_[first] || triangleChanged_[second] || vertexChanged_[left] || vertexChanged_[right]) {
    leaveOpen(*quad);
    return std::nullopt;
  }
  if (isDelaunay(start, end, left, right)) return std::nullopt;
  if (exists(left, right)) {
    leaveOpen(*quad);
    return std::nullopt;
  }
  const auto& at = mesh_.positions;
  const auto normal = [&](uint32_t a, uint32_t b, uint32_t e) {
    return normalized(cross(at[b] - at[a], at[e] - at[a]));
  };
  const Vec3 before[2] = {normal(left, start, end), normal(right, end, start)};
  const Vec3 after[2] = {normal(left, start, right), normal(left, right, end)};
  for (const Vec3& m : before)
    for (const Vec3& n : after)
      if (dot(m, n) < kFlat) return std::nullopt;
  const bool isKept = liftOf(at[start], at[end], at[left], at[right]) <= limits_.mostLift &&
                      std::min(smallestAngle(at[left], at[start], at[right]),
                               smallestAngle(at[left], at[right], at[end])) >= limits_.minAngle;
  return isKept ? quad : std::nullopt;
}

// The two triangles of the mirror image of an edge, if both can be flipped together.
std::optional<EdgeQuad> Flipping::imageOf(const EdgeQuad& quad) {
  const Topology::Edge* edge =
      edgeBetween(topology_, limits_.partners[quad.start], limits_.partners[quad.end]);
  const std::optional<EdgeQuad> image = edge ? wantedQuad(*edge) : std::nullopt;
  if (!image) return std::nullopt;
  const bool isApart = image->first != quad.first && image->first != quad.second &&
                       image->second != quad.first && image->second != quad.second;
  const bool isSameEdge = std::minmax(image->left, image->right) == std::minmax(quad.left, quad.right);
  return isApart && !isSameEdge ? image : std::nullopt;
}

uint32_t Flipping::tryFlip(const Topology::Edge& edge) {
  const std::optional<EdgeQuad> quad = wantedQuad(edge);
  if (!quad) return 0;
  leaveOpen(*quad);
  const std::optional<EdgeQuad> image = limits_.partners.empty() ? std::nullopt : imageOf(*quad);
  if (!limits_.partners.empty() && !image) return 0;
  flip(*quad);
  if (image) {
    leaveOpen(*image);
    flip(*image);
  }
  return image ? 2 : 1;
}

void Flipping::flip(const EdgeQuad& quad) {
  flipEdge(quad, mesh_, corners_);
  triangleChanged_[quad.first] = triangleChanged_[quad.second] = 1;
  // Another flip between changed vertices in this pass could create the same edge.
  vertexChanged_[quad.left] = vertexChanged_[quad.right] = 1;
}

}  // namespace

uint32_t flipToDelaunay(TriangleMesh& mesh, const FlipLimits& limits, std::vector<uint32_t>& corners) {
  Flipping flipping(mesh, limits, corners);
  uint32_t total = 0;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const uint32_t flips = flipping.pass();
    total += flips;
    if (flips == 0) break;
  }
  return total;
}

}  // namespace limber
