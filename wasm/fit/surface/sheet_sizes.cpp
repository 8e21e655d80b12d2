#include "fit/surface/sheet_sizes.h"

#include "mesh/eigen_vec3.h"

namespace limber {

SheetSizes measureSizes(const TriangleMesh& mesh, const Topology& topology) {
  SheetSizes sizes{Eigen::Vector2d::Zero(), {}};
  sizes.gradients.setZero(3 * static_cast<Eigen::Index>(mesh.vertexCount()), 2);
  const auto add = [&](uint32_t v, int column, const Vec3& derivative) {
    sizes.gradients.col(column).segment<3>(3 * static_cast<Eigen::Index>(v)) += eigen(derivative);
  };
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    sizes.values[0] += triangleArea(mesh, t);
    const Vec3 normal = normalized(areaNormal(mesh, t));
    for (int c = 0; c < 3; ++c)
      add(mesh.triangles[t][static_cast<size_t>(c)], 0,
          cross(normal, mesh.corner(t, (c + 2) % 3) - mesh.corner(t, (c + 1) % 3)) / 2);
  }
  for (const Topology::Edge& edge : topology.edges) {
    if (edge.useCount != 1) continue;
    const Vec3 along = mesh.positions[edge.b] - mesh.positions[edge.a];
    sizes.values[1] += length(along);
    add(edge.a, 1, normalized(along) * -1);
    add(edge.b, 1, normalized(along));
  }
  return sizes;
}

}  // namespace limber
