#include "fit/surface/sheet_sizes.h"

#include <Eigen/Dense>

#include "base/parallel.h"
#include "mesh/eigen_vec3.h"
#include "mesh/vertex_areas.h"

namespace limber {

namespace {

constexpr size_t kVerticesPerRange = 8192;

// The derivative of the area with respect to the position of a corner of a triangle.
Vec3 areaGradient(const TriangleMesh& mesh, Corner corner) {
  const uint32_t t = corner.triangle();
  const Vec3 opposite =
      mesh.corner(t, previousIndex(corner.index())) - mesh.corner(t, nextIndex(corner.index()));
  return cross(normalized(areaNormal(mesh, t)), opposite) / 2;
}

}  // namespace

Eigen::Vector2d measureSizes(const TriangleMesh& mesh, const Topology& topology) {
  Eigen::Vector2d sizes(surfaceArea(mesh), 0);
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount == 1) sizes[1] += length(mesh.positions[edge.b] - mesh.positions[edge.a]);
  return sizes;
}

Eigen::MatrixX2d sizeGradients(const TriangleMesh& mesh, const Topology& topology) {
  Eigen::MatrixX2d gradients = Eigen::MatrixX2d::Zero(3 * static_cast<Eigen::Index>(mesh.vertexCount()), 2);
  const auto at = [&](uint32_t v, int column) {
    return gradients.col(column).segment<3>(3 * static_cast<Eigen::Index>(v));
  };
  parallelFor(mesh.vertexCount(), kVerticesPerRange, [&](size_t begin, size_t end) {
    for (auto v = static_cast<uint32_t>(begin); v < end; ++v)
      for (const Corner corner : topology.cornersAt(v)) at(v, 0) += eigen(areaGradient(mesh, corner));
  });
  for (const Topology::Edge& edge : topology.edges) {
    if (edge.useCount != 1) continue;
    const Eigen::Vector3d along = eigen(normalized(mesh.positions[edge.b] - mesh.positions[edge.a]));
    at(edge.a, 1) -= along;
    at(edge.b, 1) += along;
  }
  return gradients;
}

}  // namespace limber
