#include "pipeline/mirror_result.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mesh/topology.h"
#include "pipeline/chart_sides.h"
#include "simplify/mirror.h"

namespace limber {
namespace {

[[noreturn]] void refuse() {
  throw std::invalid_argument("Only a result that is its own mirror image can be mirrored after a fit.");
}

// Per vertex of a result the one that is its image.
std::vector<uint32_t> partnersIn(const MeshAt& result, std::span<const uint32_t> partners) {
  std::vector<uint32_t> own;
  for (const uint32_t input : result.inputOfVertex) own.push_back(result.vertexOfInput[partners[input]]);
  for (uint32_t v = 0; v < own.size(); ++v)
    if (own[v] >= own.size() || own[own[v]] != v) refuse();
  return own;
}

Triangle sorted(Triangle t) {
  std::ranges::sort(t);
  return t;
}

// Per triangle the one that is its image.
std::vector<uint32_t> triangleImages(const TriangleMesh& mesh, const std::vector<uint32_t>& partners) {
  std::vector<std::pair<Triangle, uint32_t>> known;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) known.emplace_back(sorted(mesh.triangles[t]), t);
  std::ranges::sort(known);
  std::vector<uint32_t> images;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::pair<Triangle, uint32_t> image(sorted({partners[a], partners[b], partners[c]}), 0);
    const auto found = std::ranges::lower_bound(known, image);
    if (found == known.end() || found->first != image.first) refuse();
    images.push_back(found->second);
  }
  return images;
}

// The flips of a fit, in groups of triangles that have taken part together, and their images.
class MirroredFlips {
 public:
  MirroredFlips(const MeshAt& reduced, const MeshAt& fitted, const std::vector<uint32_t>& partners,
                const MirrorPlane& plane)
      : before_(reduced.mesh),
        after_(fitted),
        partners_(partners),
        plane_(plane),
        topology_(buildTopology(before_)),
        image_(triangleImages(before_, partners)) {}

  // The triangles and corners of `result`, which are those before all flips, after the flips that can stay.
  void apply(const MeshAt& reduced, const ChartSides& sides, MeshAt& result) {
    findGroups();
    std::vector<uint8_t> stays(before_.triangleCount(), 1);  // by the first triangle of a group
    for (uint32_t t = 0; t < stays.size(); ++t)
      if (!isAhead(t) || hasSeam(t, reduced, sides)) stays[group_[t]] = 0;
    for (uint32_t t = 0; t < stays.size(); ++t)
      if (isChanged(t) && stays[group_[t]]) {
        carry(t, result);
        carryImage(t, result);
      }
    if (buildTopology(result.mesh).edges.size() != topology_.edges.size()) takeBack(result);
  }

 private:
  bool isChanged(uint32_t t) const { return before_.triangles[t] != after_.mesh.triangles[t]; }

  // Joins changed triangles that share an edge under the first of them.
  void findGroups() {
    group_.resize(before_.triangleCount());
    std::iota(group_.begin(), group_.end(), 0u);
    for (const Topology::Edge& edge : topology_.edges) {
      const auto around = topology_.trianglesAt(edge);
      if (around.size() != 2 || !isChanged(around[0]) || !isChanged(around[1])) continue;
      const uint32_t a = root(around[0]), b = root(around[1]);
      group_[std::max(a, b)] = std::min(a, b);
    }
    for (uint32_t t = 0; t < group_.size(); ++t) group_[t] = root(t);
  }
  uint32_t root(uint32_t t) {
    while (group_[t] != t) t = group_[t] = group_[group_[t]];
    return t;
  }

  // Whether a triangle lies on the side that the normal points to; it may touch the plane.
  bool isAhead(uint32_t t) const {
    return std::ranges::all_of(before_.triangles[t], [&](uint32_t v) {
      return partners_[v] == v || plane_.height(before_.positions[v]) > 0;
    });
  }

  // Whether a seam parts the image of a triangle from that of another one of its group.
  bool hasSeam(uint32_t t, const MeshAt& reduced, const ChartSides& sides) const {
    const auto sideAt = [&](uint32_t triangle, uint32_t v) {
      return sides.sideOf(3 * reduced.inputOfTriangle[triangle] + cornerAt(before_, triangle, v) % 3);
    };
    for (uint32_t c = 0; c < 3; ++c) {
      const auto around = topology_.trianglesAt(topology_.edges[topology_.edgeOfCorner[3 * t + c]]);
      if (around.size() != 2) continue;
      const uint32_t other = around[0] == t ? around[1] : around[0];
      if (group_[other] != group_[t]) continue;
      for (const uint32_t k : {(c + 1) % 3, (c + 2) % 3}) {
        const uint32_t v = partners_[before_.triangles[t][k]];
        if (sideAt(image_[t], v) != sideAt(image_[other], v)) return true;
      }
    }
    return false;
  }

  void carry(uint32_t t, MeshAt& result) const {
    result.mesh.triangles[t] = after_.mesh.triangles[t];
    for (uint32_t c = 0; c < 3; ++c) result.flips.corners[3 * t + c] = after_.flips.corners[3 * t + c];
  }

  void carryImage(uint32_t t, MeshAt& result) const {
    const uint32_t image = image_[t];
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t from = (3 - c) % 3, v = partners_[after_.mesh.triangles[t][from]];
      result.mesh.triangles[image][c] = v;
      const uint32_t source = after_.flips.corners[3 * t + from] / 3;
      result.flips.corners[3 * image + c] = cornerAt(before_, image_[source], v);
    }
  }

  void takeBack(MeshAt& result) const {
    result.mesh.triangles = before_.triangles;
    std::iota(result.flips.corners.begin(), result.flips.corners.end(), 0u);
  }

  const TriangleMesh& before_;
  const MeshAt& after_;
  const std::vector<uint32_t>& partners_;
  const MirrorPlane& plane_;
  Topology topology_;
  std::vector<uint32_t> image_, group_;  // per triangle
};

Vec3 inFile(const Vec3& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Both sides' positions at their mean. A locked vertex leads its partner.
void mirrorPositions(const std::vector<uint32_t>& partners, const std::vector<uint8_t>& isLocked,
                     const MirrorPlane& plane, std::vector<Vec3>& positions) {
  for (uint32_t v = 0; v < positions.size(); ++v) {
    const uint32_t other = partners[v];
    if (other < v || (isLocked[v] && isLocked[other])) continue;
    if (other == v)
      positions[v] = inFile(plane.onto(positions[v]));
    else if (isLocked[other])
      positions[v] = inFile(plane.image(positions[other]));
    else {
      if (!isLocked[v]) positions[v] = inFile((positions[v] + plane.image(positions[other])) / 2);
      positions[other] = inFile(plane.image(positions[v]));
    }
  }
}

// Whether no face of `mesh` has turned since its vertices were at `before`.
bool hasNoTurnedFace(const TriangleMesh& mesh, const std::vector<Vec3>& before) {
  const TriangleMesh start{before, mesh.triangles};
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const Vec3 normal = areaNormal(start, t);
    if (squaredLength(normal) > 0 && !(dot(normal, areaNormal(mesh, t)) > 0)) return false;
  }
  return true;
}

std::vector<uint8_t> lockedIn(const MeshAt& result, std::span<const uint8_t> locked) {
  std::vector<uint8_t> isLocked(result.mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < locked.size(); ++v)
    if (locked[v] && result.vertexOfInput[v] != kNone) isLocked[result.vertexOfInput[v]] = 1;
  return isLocked;
}

}  // namespace

MeshAt mirrorResult(const TriangleMesh& input, const MeshAt& reduced, const MeshAt& fitted,
                    const MirrorRequest& request) {
  const uint32_t corners = 3 * reduced.mesh.triangleCount();
  if (request.partners.size() != input.vertexCount() ||
      fitted.mesh.vertexCount() != reduced.mesh.vertexCount() ||
      fitted.mesh.triangleCount() != reduced.mesh.triangleCount() ||
      (!fitted.flips.corners.empty() && fitted.flips.corners.size() != corners))
    refuse();
  const std::vector<uint32_t> partners = partnersIn(reduced, request.partners);
  const MirrorPlane plane = fitMirrorPlane(input.positions, request.partners);
  MeshAt result = reduced;
  if (!fitted.flips.corners.empty()) {
    result.flips.triangles = reduced.mesh.triangles;
    result.flips.corners.resize(corners);
    std::iota(result.flips.corners.begin(), result.flips.corners.end(), 0u);
    const ChartSides sides(input, buildTopology(input), request.charts, reduced);
    MirroredFlips(reduced, fitted, partners, plane).apply(reduced, sides, result);
  }
  result.mesh.positions = fitted.mesh.positions;
  mirrorPositions(partners, lockedIn(reduced, request.locked), plane, result.mesh.positions);
  return hasNoTurnedFace(result.mesh, reduced.mesh.positions) ? result : reduced;
}

}  // namespace limber
