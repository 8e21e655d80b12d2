#include "simplify/symmetry/mirror.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace limber {
namespace {

// Of the diagonal: how far a vertex may lie from the image of its partner.
constexpr double kSymmetry = 1e-4;

[[noreturn]] void refuse() {
  throw std::invalid_argument(
      "The mirror is no symmetry of this mesh: give every vertex its image, and itself on the plane.");
}

// A triangle, rotated so that its lowest vertex comes first.
Triangle lowestFirst(const Triangle& t) {
  if (t[0] < t[1] && t[0] < t[2]) return t;
  return t[1] < t[2] ? Triangle{t[1], t[2], t[0]} : Triangle{t[2], t[0], t[1]};
}

void checkPartners(const TriangleMesh& mesh, std::span<const uint32_t> partners) {
  if (partners.size() != mesh.vertexCount()) refuse();
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (partners[v] >= mesh.vertexCount() || partners[partners[v]] != v) refuse();
  if (trianglesWithoutImage(mesh, partners) > 0) refuse();
}

}  // namespace

std::vector<uint8_t> asymmetricTriangles(const TriangleMesh& mesh, std::span<const uint32_t> partners) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangleCount());
  for (const Triangle& t : mesh.triangles) triangles.push_back(lowestFirst(t));
  std::ranges::sort(triangles);
  std::vector<uint8_t> isAsymmetric;
  isAsymmetric.reserve(mesh.triangleCount());
  for (const Triangle& t : mesh.triangles)
    isAsymmetric.push_back(!std::ranges::binary_search(
        triangles, lowestFirst({partners[t[0]], partners[t[2]], partners[t[1]]})));
  return isAsymmetric;
}

uint32_t trianglesWithoutImage(const TriangleMesh& mesh, std::span<const uint32_t> partners) {
  return static_cast<uint32_t>(std::ranges::count(asymmetricTriangles(mesh, partners), 1));
}

MirrorPlane fitMirrorPlane(std::span<const Vec3> positions, std::span<const uint32_t> partners) {
  MirrorPlane plane;
  Vec3 across;
  for (uint32_t v = 0; v < partners.size(); ++v) {
    const Vec3 way = positions[partners[v]] - positions[v];
    across += dot(across, way) < 0 ? -way : way;
  }
  plane.normal = normalized(across);
  double sum = 0;
  for (uint32_t v = 0; v < partners.size(); ++v)
    sum += dot(plane.normal, positions[v] + positions[partners[v]]) / 2;
  if (!partners.empty()) plane.offset = sum / static_cast<double>(partners.size());
  return plane;
}

Mirror::Mirror(const TriangleMesh& input, const CollapseMesh& mesh, std::span<const uint32_t> partners)
    : mesh_(mesh), partners_(partners) {
  checkPartners(input, partners);
  std::vector<Vec3> positions;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) positions.push_back(mesh.position(v));
  plane_ = fitMirrorPlane(positions, partners);
  checkPositions();
}

void Mirror::checkPositions() const {
  const double limit = kSymmetry * mesh_.diagonal();
  for (uint32_t v = 0; v < partners_.size(); ++v)
    if (!(length(plane_.image(mesh_.position(v)) - mesh_.position(partners_[v])) <= limit)) refuse();
}

Collapse Mirror::onPlane(const Collapse& step) const {
  Collapse moved = step;
  if (mesh_.fixedEnd(step.edge) == kNone) moved.target = mesh_.stored(plane_.onto(step.target));
  return moved;
}

Collapse Mirror::imageOf(const Collapse& step) const {
  const uint32_t kept = partners_[step.kept], removed = partners_[step.removed];
  uint32_t edge = kNone;
  mesh_.forEachEdge(kept, [&](uint32_t e, uint32_t other) {
    if (other == removed) edge = e;
  });
  return {edge, kept, removed, imageTarget(edge, kept, step)};
}

// A fixed vertex may differ slightly from the image of its partner, see kSymmetry.
Vec3 Mirror::imageTarget(uint32_t edge, uint32_t kept, const Collapse& step) const {
  if (isOnPlane(kept)) return step.target;
  const bool isFixed = edge != kNone && mesh_.fixedEnd(edge) == kept;
  return mesh_.stored(isFixed ? mesh_.position(kept) : plane_.image(step.target));
}

bool Mirror::areNeighbours(uint32_t a, uint32_t b) const {
  bool found = false;
  mesh_.forEachEdge(a, [&](uint32_t, uint32_t other) { found = found || other == b; });
  return found;
}

// Whether the step would turn its image, which collapses into the same vertex of the plane, into one of the
// two cases that Legality::keepsTopology forbids: a tetrahedron and a lone triangle.
bool Mirror::forbidsImage(const Collapse& step) const {
  const size_t kept = mesh_.star(step.kept).size(), removed = mesh_.star(step.removed).size();
  if (mesh_.trianglesOnEdge(step.edge) == 1) return kept == 2 && removed == 1;
  const bool inside = !mesh_.role(step.kept).onBorder && !mesh_.role(step.removed).onBorder;
  return inside && kept == 4 && removed == 3;
}

bool Mirror::isApart(const Collapse& step) const {
  const uint32_t kept = step.kept, removed = step.removed;
  const uint32_t keptImage = partners_[kept], removedImage = partners_[removed];
  if (isOnPlane(removed) || removedImage == kept || areNeighbours(removed, removedImage)) return false;
  if (keptImage != kept)
    return !areNeighbours(kept, keptImage) && !areNeighbours(kept, removedImage) &&
           !areNeighbours(removed, keptImage);
  // Both collapse into one vertex of the plane, which does not move.
  if (mesh_.fixedEnd(step.edge) != kept || forbidsImage(step)) return false;
  // Their common neighbours must already be neighbours of that vertex.
  bool apart = true;
  mesh_.forEachEdge(removed, [&](uint32_t, uint32_t other) {
    if (other != kept && areNeighbours(removedImage, other) && !areNeighbours(kept, other)) apart = false;
  });
  return apart;
}

}  // namespace limber
