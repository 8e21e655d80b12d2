#include "simulate/solid/solid_split.h"

#include <utility>

#include "mesh/topology.h"
#include "mesh/vertex_areas.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

SolidSplit::SolidSplit(const TriangleMesh& mesh) : diagonal(bounds(mesh).diagonal()) {
  Topology topology = buildTopology(mesh);
  const std::vector<uint8_t> isSolid = solidComponents(mesh);
  edgeCount = static_cast<uint32_t>(topology.edges.size());
  std::vector<uint32_t> partOfVertex;
  for (const uint32_t component : topology.componentOfVertex) {
    isSolidVertex.push_back(isSolid[component]);
    partOfVertex.push_back(isSolid[component]);
  }
  componentOfVertex = std::move(topology.componentOfVertex);
  MeshParts split = splitMesh(mesh, partOfVertex, 2);
  localVertex = std::move(split.localVertex);
  isSolidTriangle.assign(mesh.triangleCount(), 0);
  localTriangle.resize(mesh.triangleCount());
  for (uint8_t part = 0; part < 2; ++part)
    for (uint32_t t = 0; t < split.parts[part].triangles.size(); ++t) {
      isSolidTriangle[split.parts[part].triangles[t]] = part;
      localTriangle[split.parts[part].triangles[t]] = t;
    }
  sheets = std::move(split.parts[0].mesh);
  solids = std::move(split.parts[1].mesh);
  sheetArea = surfaceArea(sheets);
  sheetVertices = std::move(split.parts[0].vertices);
  solidVertices = std::move(split.parts[1].vertices);
}

void SolidSplit::splitPins(const Pins& pins) {
  uint32_t pin = 0;
  for (const uint32_t v : pins.vertices) {
    (isSolidVertex[v] ? solidPins : sheetPins).vertices.push_back(localVertex[v]);
    (isSolidVertex[v] ? solidPinIndices : sheetPinIndices).push_back(pin++);
  }
  for (const SurfacePoint& point : pins.points) {
    const bool isSolid = isSolidTriangle[point.triangle];
    (isSolid ? solidPins : sheetPins).points.push_back(local(point));
    (isSolid ? solidPinIndices : sheetPinIndices).push_back(pin++);
  }
}

SurfacePoint SolidSplit::local(const SurfacePoint& point) const {
  SurfacePoint own = point;
  own.triangle = localTriangle[point.triangle];
  return own;
}

std::vector<Vec3> SolidSplit::chosen(std::span<const Vec3> values, std::span<const uint32_t> indices) {
  std::vector<Vec3> own;
  for (const uint32_t i : indices) own.push_back(values[i]);
  return own;
}

}  // namespace limber
