#include "mesh/triangle_mesh.h"

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
  for (const Vec3& p : mesh.positions) box.include(p);
  return box;
}

}  // namespace limber
