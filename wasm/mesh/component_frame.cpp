#include "mesh/component_frame.h"

namespace limber {

MeshParts splitMesh(const TriangleMesh& mesh, std::span<const uint32_t> partOfVertex, uint32_t partCount) {
  MeshParts split{std::vector<MeshParts::Part>(partCount), std::vector<uint32_t>(mesh.vertexCount())};
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    MeshParts::Part& part = split.parts[partOfVertex[v]];
    split.localVertex[v] = part.mesh.vertexCount();
    part.mesh.positions.push_back(mesh.positions[v]);
    part.vertices.push_back(v);
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    MeshParts::Part& part = split.parts[partOfVertex[a]];
    part.mesh.triangles.push_back({split.localVertex[a], split.localVertex[b], split.localVertex[c]});
    part.triangles.push_back(t);
  }
  return split;
}

UnitFrame unitFrame(const TriangleMesh& mesh) {
  const Bounds box = bounds(mesh);
  return {box.low, box.diagonal() > 0 ? box.diagonal() : 1};
}

void moveToFrame(TriangleMesh& mesh, const UnitFrame& frame) {
  for (Vec3& p : mesh.positions) p = frame.toFrame(p);
}

}  // namespace limber
