#include "fit/surface/border_corners.h"

#include <cmath>
#include <numbers>

namespace limber {

namespace {

// An outline turns by more than 30 degrees at its corners, see docs/glossary.md.
constexpr double kStraight = std::numbers::pi, kCornerAngle = std::numbers::pi / 6;

double interiorAngle(const TriangleMesh& mesh, const Topology& topology, uint32_t v) {
  double sum = 0;
  for (const Corner corner : topology.cornersAt(v)) {
    const uint32_t t = corner.triangle();
    const Vec3 p = mesh.corner(t, nextIndex(corner.index())) - mesh.positions[v];
    const Vec3 q = mesh.corner(t, previousIndex(corner.index())) - mesh.positions[v];
    sum += std::atan2(length(cross(p, q)), dot(p, q));
  }
  return sum;
}

}  // namespace

std::vector<uint8_t> findBorderCorners(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint8_t> isCorner(mesh.vertexCount(), 0);
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount == 1)
      for (const uint32_t v : {edge.a, edge.b})
        isCorner[v] = std::abs(interiorAngle(mesh, topology, v) - kStraight) > kCornerAngle;
  return isCorner;
}

}  // namespace limber
