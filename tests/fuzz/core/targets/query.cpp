// Closest points, nearest triangles and vertices: what the searches find must agree with a search of everything.

#include <algorithm>

#include "promises.h"
#include "query/closest_among.h"
#include "query/closest_point.h"
#include "query/nearest.h"
#include "query/surface_walk.h"
#include "soup.h"

namespace limber::fuzz {
namespace {

// A point that is anywhere, near the surface, or one of its vertices.
Vec3 drawPoint(FuzzInput& input, const TriangleMesh& mesh) {
  if (input.chance(32)) return {input.anyFloat(), input.anyFloat(), input.anyFloat()};
  const Vec3 at = mesh.positions[input.below(mesh.vertexCount())];
  if (input.chance(64)) return at;
  const double reach = bounds(mesh).diagonal() * std::pow(10, input.real(-9, 2));
  return at + Vec3{input.real(-reach, reach), input.real(-reach, reach), input.real(-reach, reach)};
}

void requirePointOn(const TriangleMesh& mesh, const ClosestPoint& found) {
  require(found.triangle < mesh.triangleCount(), "a closest point lies on a triangle that exists");
  double sum = 0;
  for (const double part : found.barycentric) {
    require(part >= 0 && part <= 1 + 1e-8, "a barycentric coordinate is within 0 and 1");
    sum += part;
  }
  require(std::abs(sum - 1) <= 1e-7, "the sum of barycentric coordinates is 1");
  require(isFinite(found.position), "a closest point is finite");
  require(found.distance >= 0 && std::isfinite(found.distance), "a distance is finite");
}

double leastDistance(const TriangleMesh& mesh, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    least = std::min(least, closestOnTriangle(mesh, t, point).distance);
  return least;
}

}  // namespace

void fuzzQuery(FuzzInput& input) {
  const TriangleMesh mesh = drawMesh(input, 120);
  if (mesh.triangleCount() == 0) return;
  const ClosestPointTree tree(mesh);
  const NearestTriangle nearestTriangle(mesh);
  const NearestVertex nearestVertex(mesh);
  const Topology topology = buildTopology(mesh);
  SurfaceWalk walk(mesh, topology);
  for (int round = 0; round < 8 && !input.isUsedUp(); ++round) {
    const Vec3 point = drawPoint(input, mesh);
    if (!isFinite(point)) continue;
    const uint32_t guess = input.below(mesh.triangleCount());
    const ClosestPoint found = tree.closest(point, guess);
    requirePointOn(mesh, found);
    const double least = leastDistance(mesh, point);
    const double tolerance = 1e-6 * (least + bounds(mesh).diagonal());
    require(std::abs(found.distance - least) <= tolerance, "no triangle is closer than the closest point");
    const double enough = least * input.real(0, 3);
    require(tree.nearEnough(point, enough, guess).distance <= std::max(enough, least) + tolerance,
            "a point that is near enough is as near as was asked");
    const Vec3 normal{input.real(-1, 1), input.real(-1, 1), input.real(-1, 1)};
    requirePointOn(mesh, tree.closestFacing(point, normal, guess));
    requirePointOn(mesh, closestAmong(mesh, {}, point));
    require(nearestTriangle.find(point, guess) < mesh.triangleCount(), "the nearest triangle exists");
    require(nearestVertex.find(point, input.below(mesh.vertexCount())) < mesh.vertexCount(),
            "the nearest vertex exists");
    const ClosestPoint walked = walk.closest(point, {{guess}}, [](uint32_t, uint32_t) { return true; });
    requirePointOn(mesh, walked);
    require(walked.distance >= least - tolerance, "a walk finds nothing closer than the closest point");
  }
}

}  // namespace limber::fuzz
