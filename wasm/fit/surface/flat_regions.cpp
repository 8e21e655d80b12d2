#include "fit/surface/flat_regions.h"

#include <algorithm>

#include "mesh/eigen_vec3.h"
#include "mesh/manifold.h"

namespace limber {

namespace {

constexpr double kFlat = 1e-3;    // largest sine between normals of one plane; float32 rounding causes less
constexpr double kApart = 0.02;   // smallest sine between two planes that meet in an edge
constexpr double kPenalty = 1e4;  // of leaving a plane, relative to the vertex's own diagonal block

using Directions = std::vector<Eigen::Vector3d>;

// The unit normal; 0 for a triangle without area, which is in no plane.
Eigen::Vector3d unitNormal(const TriangleMesh& mesh, uint32_t t) {
  return eigen(normalized(areaNormal(mesh, t)));
}

bool isAlong(const Eigen::Vector3d& normal, const Eigen::Vector3d& plane) {
  return normal.dot(plane) > 0.5 && normal.cross(plane).norm() < kFlat;
}

// Whether the triangles around v lie in one plane; `plane` becomes its normal.
bool isInPlane(uint32_t v, const Topology& topology, const Directions& normals, Eigen::Vector3d& plane) {
  plane.setZero();
  for (const uint32_t t : topology.trianglesAround(v)) plane += normals[t];
  plane.normalize();
  return std::ranges::all_of(topology.trianglesAround(v),
                             [&](uint32_t t) { return isAlong(normals[t], plane); });
}

// `first` and the triangles that are connected to it through triangles for which belongs(triangle) is true.
// Marks them in `seen`.
template <class Belongs>
std::vector<uint32_t> connectedTriangles(uint32_t first, const Topology& topology, std::vector<uint8_t>& seen,
                                         const Belongs& belongs) {
  std::vector<uint32_t> found, waiting{first};
  seen[first] = 1;
  while (!waiting.empty()) {
    const uint32_t t = waiting.back();
    waiting.pop_back();
    found.push_back(t);
    for (uint32_t c = 0; c < 3; ++c)
      for (const uint32_t next : topology.trianglesAt(topology.edges[topology.edgeOpposite(Corner(t, c))]))
        if (!seen[next] && belongs(next)) {
          seen[next] = 1;
          waiting.push_back(next);
        }
  }
  return found;
}

// Adds the part of a plane's normal that is orthogonal to the previous columns (Gram-Schmidt); columns
// without a direction are 0.
void addAcross(const Eigen::Vector3d& normal, Eigen::Matrix3d& across) {
  const Eigen::Vector3d rest = normal - across * (across.transpose() * normal);
  if (rest.norm() < kApart) return;
  for (int k = 0; k < 3; ++k)
    if (across.col(k).isZero()) {
      across.col(k) = rest.normalized();
      return;
    }
}

}  // namespace

FlatRegions::FlatRegions(const TriangleMesh& original, const ClosestPointTree& surface,
                         const TriangleMesh& mesh, const Topology& topology) {
  Directions normals(mesh.triangleCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) normals[t] = unitNormal(mesh, t);
  const std::vector<VertexKind> kinds = classifyVertices(mesh, topology);
  std::vector<uint8_t> seen(mesh.triangleCount(), 0);
  std::vector<Eigen::Matrix3d> across(mesh.vertexCount(), Eigen::Matrix3d::Zero());
  Eigen::Vector3d plane;
  const auto belongs = [&](uint32_t t) {
    if (!isAlong(normals[t], plane)) return false;
    const ClosestPoint nearest =
        surface.closestFacing(triangleCentre(mesh, t), {plane.x(), plane.y(), plane.z()});
    return isAlong(unitNormal(original, nearest.triangle), plane);
  };
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (kinds[v] != VertexKind::Interior) continue;
    const auto fan = topology.trianglesAround(v);
    if (seen[fan.front()] || !isInPlane(v, topology, normals, plane)) continue;
    if (!std::ranges::all_of(fan, belongs)) continue;
    for (const uint32_t t : connectedTriangles(fan.front(), topology, seen, belongs))
      for (const uint32_t corner : mesh.triangles[t]) addAcross(plane, across[corner]);
  }
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    if (!across[v].isZero()) vertices_.push_back({v, across[v]});
}

void FlatRegions::stiffen(BlockMatrix& hessian) const {
  for (const auto& [v, across] : vertices_) {
    Eigen::Matrix3d& own = hessian.at(v, v);
    own += kPenalty * own.trace() * across * across.transpose();
  }
}

void FlatRegions::flatten(Eigen::MatrixXd& displacements) const {
  for (const auto& [v, across] : vertices_) {
    auto rows = displacements.middleRows<3>(3 * static_cast<Eigen::Index>(v));
    rows -= across * (across.transpose() * rows).eval();
  }
}

}  // namespace limber
