#include "simulate/pose.h"

#include <algorithm>

#include "mesh/principal_axes.h"

namespace limber {

namespace {

constexpr double kFlat = 0.25;

// The extent of the mesh along a unit vector, from end to end.
double lengthAlong(const TriangleMesh& mesh, const Vec3& axis) {
  double low = dot(mesh.positions.front(), axis), high = low;
  for (const Vec3& p : mesh.positions) {
    low = std::min(low, dot(p, axis));
    high = std::max(high, dot(p, axis));
  }
  return high - low;
}

Vec3 shortestSide(const Bounds& box) {
  const Vec3 size = box.high - box.low;
  int shortest = 2;
  for (int c = 1; c >= 0; --c)
    if (size[c] < size[shortest]) shortest = c;
  Vec3 side;
  side[shortest] = 1;
  return side;
}

// The direction that becomes vertical, upwards if it is not horizontal.
Vec3 normalOf(const TriangleMesh& mesh, const Bounds& box) {
  const PrincipalAxes axes = principalAxes(mesh);
  const bool isSheet = lengthAlong(mesh, axes.axis[0]) < kFlat * lengthAlong(mesh, axes.axis[1]);
  const Vec3 normal = isSheet ? axes.axis[0] : shortestSide(box);
  return normal.y < 0 ? normal * -1.0 : normal;
}

}  // namespace

// Rodrigues' formula for the rotation of the normal n to y: with v = n x y and c = n . y, I + [v] + [v]^2 /
// (1 + c).
Pose layFlat(const TriangleMesh& mesh) {
  Pose pose;
  pose.box = bounds(mesh);
  pose.centre = (pose.box.low + pose.box.high) * 0.5;
  const Vec3 n = normalOf(mesh, pose.box);
  const double s = 1 / (1 + n.y);
  pose.rows = {{{1 - s * n.x * n.x, -n.x, -s * n.x * n.z}, n, {-s * n.x * n.z, -n.z, 1 - s * n.z * n.z}}};
  Bounds box = {pose.of(mesh.positions.front()), pose.of(mesh.positions.front())};
  for (const Vec3& p : mesh.positions) box.include(pose.of(p));
  pose.box = box;
  return pose;
}

}  // namespace limber
