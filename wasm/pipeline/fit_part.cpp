#include "pipeline/fit_part.h"

#include "mesh/topology.h"

namespace limber {

namespace {

// The triangles of a mesh that belong to one component; `vertexOf` and `triangleOf` say where they come from.
TriangleMesh extract(const TriangleMesh& mesh, const std::vector<uint32_t>& componentOfVertex,
                     uint32_t component, std::vector<uint32_t>& vertexOf, std::vector<uint32_t>& triangleOf) {
  TriangleMesh part;
  std::vector<uint32_t> number(mesh.vertexCount(), kNone);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (componentOfVertex[v] != component) continue;
    number[v] = part.vertexCount();
    vertexOf.push_back(v);
    part.positions.push_back(mesh.positions[v]);
  }
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (componentOfVertex[a] != component) continue;
    triangleOf.push_back(t);
    part.triangles.push_back({number[a], number[b], number[c]});
  }
  return part;
}

void intoFrame(TriangleMesh& mesh, const FitPart& part) {
  for (Vec3& p : mesh.positions) p = (p - part.origin) / part.diagonal;
}

// Which corner of the input, by chart, a corner of the result belongs to; an edge is a seam where its two
// triangles disagree.
EdgeList seamsOf(const MeshAt& simplified, const ChartSides& sides) {
  const TriangleMesh& mesh = simplified.mesh;
  const Topology topology = buildTopology(mesh);
  const auto sideAt = [&](uint32_t t, uint32_t v) {
    return sides.sideOf(3 * simplified.inputOfTriangle[t] + cornerAt(mesh, t, v) % 3);
  };
  EdgeList seams;
  for (const Topology::Edge& edge : topology.edges) {
    const auto around = topology.trianglesAt(edge);
    if (around.size() == 2 && (sideAt(around[0], edge.a) != sideAt(around[1], edge.a) ||
                               sideAt(around[0], edge.b) != sideAt(around[1], edge.b)))
      seams.push_back({edge.a, edge.b});
  }
  return seams;
}

EdgeList seamsOf(const Topology& topology, const ChartSides& sides) {
  EdgeList seams;
  for (uint32_t e = 0; e < topology.edges.size(); ++e)
    if (sides.isSeam(e) && topology.edges[e].useCount == 2)
      seams.push_back({topology.edges[e].a, topology.edges[e].b});
  return seams;
}

// Those edges of a list that lie in a part, by its own numbers.
EdgeList within(const EdgeList& edges, const std::vector<uint32_t>& vertexOf, uint32_t vertexCount) {
  std::vector<uint32_t> number(vertexCount, kNone);
  for (uint32_t v = 0; v < vertexOf.size(); ++v) number[vertexOf[v]] = v;
  EdgeList inside;
  for (const auto& [a, b] : edges)
    if (number[a] != kNone && number[b] != kNone) inside.push_back({number[a], number[b]});
  return inside;
}

}  // namespace

std::vector<FitPart> fitParts(const TriangleMesh& original, const MeshAt& simplified,
                              const FitPartOptions& options) {
  const Topology topology = buildTopology(original);
  const TriangleMesh& mesh = simplified.mesh;
  const ChartSides sides(original, topology, options.charts, simplified);
  const EdgeList originalLines = seamsOf(topology, sides), lines = seamsOf(simplified, sides);
  std::vector<uint32_t> componentOfResult(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    componentOfResult[v] = topology.componentOfVertex[simplified.inputOfVertex[v]];
  std::vector<uint8_t> isLocked(mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < options.locked.size(); ++v)
    if (options.locked[v] && simplified.vertexOfInput[v] != kNone) isLocked[simplified.vertexOfInput[v]] = 1;
  std::vector<FitPart> parts;
  for (uint32_t component = 0; component < topology.componentCount; ++component) {
    FitPart part;
    std::vector<uint32_t> vertexOfInput, triangleOfInput;
    part.original = extract(original, topology.componentOfVertex, component, vertexOfInput, triangleOfInput);
    part.simplified = extract(mesh, componentOfResult, component, part.vertexOfResult, part.triangleOfResult);
    if (part.simplified.triangleCount() < options.fewestFaces ||
        part.simplified.vertexCount() > options.mostVertices)
      continue;
    const Bounds box = bounds(part.original);
    part.origin = box.low;
    part.diagonal = box.diagonal();
    intoFrame(part.original, part);
    intoFrame(part.simplified, part);
    part.originalLines = within(originalLines, vertexOfInput, original.vertexCount());
    part.lines = within(lines, part.vertexOfResult, mesh.vertexCount());
    for (uint32_t v : part.vertexOfResult) part.locked.push_back(isLocked[v]);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace limber
