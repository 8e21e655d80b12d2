#include "mesh/triangle_mesh.h"

#include <algorithm>

namespace limber {

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertexCount());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (const uint32_t v : mesh.triangles[t]) normals[v] += areaNormal(mesh, t);
  for (Vec3& normal : normals) normal = normalized(normal);
  return normals;
}

Bounds bounds(const TriangleMesh& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds box{mesh.positions[0], mesh.positions[0]};
  for (const Vec3& p : mesh.positions)
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  return box;
}

}  // namespace limber
