#include "fit/fit_part.h"

#include <algorithm>

#include "elastic/pins.h"
#include "mesh/topology.h"

namespace limber {

namespace {

// Members of each component: vertices, triangles and some edges of a mesh, in their order.
struct Members {
  std::vector<uint32_t> vertices, triangles;
  EdgeList edges;
};

std::vector<Members> membersOf(const TriangleMesh& mesh, const EdgeList& edges,
                               const std::vector<uint32_t>& componentOfVertex, uint32_t componentCount) {
  std::vector<Members> members(componentCount);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) members[componentOfVertex[v]].vertices.push_back(v);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    members[componentOfVertex[mesh.triangles[t][0]]].triangles.push_back(t);
  for (const auto& edge : edges) members[componentOfVertex[edge[0]]].edges.push_back(edge);
  return members;
}

// A component by its own numbers. `number`: room for one per vertex of the mesh.
TriangleMesh extract(const TriangleMesh& mesh, const Members& members, std::vector<uint32_t>& number,
                     EdgeList& edges) {
  TriangleMesh part;
  for (uint32_t v : members.vertices) {
    number[v] = part.vertexCount();
    part.positions.push_back(mesh.positions[v]);
  }
  for (uint32_t t : members.triangles) {
    const auto& [a, b, c] = mesh.triangles[t];
    part.triangles.push_back({number[a], number[b], number[c]});
  }
  for (const auto& [a, b] : members.edges) edges.push_back({number[a], number[b]});
  return part;
}

void intoFrame(TriangleMesh& mesh, const FitPart& part) {
  for (Vec3& p : mesh.positions) p = (p - part.origin) / part.diagonal;
}

// That where the original's diagonal is 1, for both meshes.
void chooseFrame(FitPart& part) {
  const Bounds box = bounds(part.original);
  part.origin = box.low;
  part.diagonal = box.diagonal();
  intoFrame(part.original, part);
  intoFrame(part.simplified, part);
}

// Which corner of the input, by chart, a corner of the result belongs to; an edge is a seam where its two
// triangles disagree.
EdgeList seamsOf(const MeshAt& simplified, const ChartSides& sides) {
  const TriangleMesh& mesh = simplified.mesh;
  const Topology topology = buildTopology(mesh);
  const auto sideAt = [&](uint32_t t, uint32_t v) {
    return sides.sideOf(Corner(simplified.inputOfTriangle[t], cornerAt(mesh, t, v).index()));
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

// Seams that stay in place, of both meshes.
struct HeldFeatureEdges {
  EdgeList original, result;
};

HeldFeatureEdges linesOf(const MeshAt& simplified, const Topology& topology, const ChartSides& sides) {
  return {seamsOf(topology, sides), seamsOf(simplified, sides)};
}

// Per vertex of the result: what has become of the marked vertices of the original.
std::vector<uint8_t> carried(const MeshAt& simplified, std::span<const uint8_t> marks) {
  std::vector<uint8_t> there(simplified.mesh.vertexCount(), 0);
  for (uint32_t v = 0; v < marks.size(); ++v)
    if (marks[v] && simplified.vertexOfInput[v] != kNone) there[simplified.vertexOfInput[v]] = 1;
  return there;
}

// Vertices of a part, by its own numbers, that are pinned in the whole. Nothing where they leave it a rigid
// motion, or nothing to move.
std::vector<uint32_t> pinnedOf(const TriangleMesh& part, const std::vector<uint32_t>& vertices,
                               std::span<const uint8_t> isPinned) {
  std::vector<uint32_t> pinned;
  std::vector<Vec3> points;
  for (uint32_t v = 0; v < vertices.size(); ++v)
    if (!isPinned.empty() && isPinned[vertices[v]]) {
      pinned.push_back(v);
      points.push_back(part.positions[v]);
    }
  const bool isHeld = rigidMotionsLeft(points) == 0 && pinned.size() < vertices.size();
  return isHeld ? pinned : std::vector<uint32_t>{};
}

// With the images of the edges.
EdgeList withImages(EdgeList edges, const std::vector<uint32_t>& partners) {
  const size_t count = edges.size();
  for (size_t i = 0; i < count; ++i) {
    const auto [a, b] = std::minmax(partners[edges[i][0]], partners[edges[i][1]]);
    edges.push_back({a, b});
  }
  std::ranges::sort(edges);
  const auto twice = std::ranges::unique(edges);
  edges.erase(twice.begin(), twice.end());
  return edges;
}

std::vector<EdgeList> byComponent(const EdgeList& edges, const std::vector<uint32_t>& componentOfVertex,
                                  uint32_t componentCount) {
  std::vector<EdgeList> lists(componentCount);
  for (const auto& edge : edges) lists[componentOfVertex[edge[0]]].push_back(edge);
  return lists;
}

// By the numbers of a part.
EdgeList renumbered(EdgeList edges, const std::vector<uint32_t>& number) {
  for (auto& [a, b] : edges) {
    a = number[a];
    b = number[b];
  }
  return edges;
}

MeshMirror mirrorIn(const FitPart& part, const ResultMirror& mirror, const std::vector<uint32_t>& number) {
  const auto& [normal, offset] = mirror.plane;
  MeshMirror own{{}, {normal, (offset - dot(normal, part.origin)) / part.diagonal}};
  for (uint32_t v : part.vertexOfResult) own.partners.push_back(number[mirror.partners[v]]);
  return own;
}

// A vertex whose image is held is held too.
void holdImages(const std::vector<uint32_t>& partners, std::vector<uint8_t>& isHeld) {
  for (uint32_t v = 0; v < isHeld.size(); ++v)
    if (isHeld[v]) isHeld[partners[v]] = 1;
}

}  // namespace

FitParts fitParts(const TriangleMesh& original, const MeshAt& simplified, const FitPartOptions& options) {
  const Topology topology = buildTopology(original);
  const TriangleMesh& mesh = simplified.mesh;
  const ChartSides sides(original, topology, options.charts, simplified);
  std::vector<uint32_t> componentOfResult(mesh.vertexCount());
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v)
    componentOfResult[v] = topology.componentOfVertex[simplified.inputOfVertex[v]];
  const std::vector<uint8_t> isPinned = carried(simplified, options.pinned);
  std::vector<uint8_t> isHeld = carried(simplified, options.locked);
  for (uint32_t v = 0; v < isHeld.size(); ++v) isHeld[v] |= isPinned[v];
  if (options.mirror) holdImages(options.mirror->partners, isHeld);
  const EdgeList seams = seamsOf(simplified, sides);
  const HeldFeatureEdges lines =
      options.holdsSeams
          ? HeldFeatureEdges{seamsOf(topology, sides), seams}
          : linesOf(simplified, topology, {original, topology, {{}, options.charts.groups}, simplified});
  const std::vector<EdgeList> fixed =
      byComponent(options.mirror ? withImages(seams, options.mirror->partners) : seams, componentOfResult,
                  topology.componentCount);
  const std::vector<Members> originals = membersOf(original, lines.original, topology.componentOfVertex,
                                                   topology.componentCount),
                             results =
                                 membersOf(mesh, lines.result, componentOfResult, topology.componentCount);
  std::vector<uint32_t> number(original.vertexCount());
  FitParts found;
  for (uint32_t component = 0; component < topology.componentCount; ++component) {
    const Members& result = results[component];
    if (result.triangles.size() < options.fewestFaces) continue;
    const uint32_t image =
        options.mirror ? componentOfResult[options.mirror->partners[result.vertices[0]]] : component;
    if (image < component) continue;
    const bool isLarge = result.vertices.size() > options.largeVertices;
    if (isLarge && originals[component].vertices.size() > options.mostOriginal) {
      ++found.tooLarge;
      continue;
    }
    FitPart part;
    part.isLarge = isLarge;
    part.original = extract(original, originals[component], number, part.originalFeatures);
    part.simplified = extract(mesh, result, number, part.lines);
    part.vertexOfResult = result.vertices;
    part.triangleOfResult = result.triangles;
    chooseFrame(part);
    part.fixedEdges = renumbered(fixed[component], number);
    part.hasImage = image != component;
    if (options.mirror && !part.hasImage) {
      part.mirror = mirrorIn(part, *options.mirror, number);
      part.mirror->symmetrise(part.simplified);
    }
    part.flats = FlatRegions(part.original, part.simplified, buildTopology(part.simplified));
    for (uint32_t v : part.vertexOfResult) part.locked.push_back(isHeld[v]);
    part.pinnedOriginal = pinnedOf(part.original, originals[component].vertices, options.pinned);
    part.pinned = pinnedOf(part.simplified, part.vertexOfResult, isPinned);
    if (part.pinned.empty() || part.pinnedOriginal.empty()) part.pinned = part.pinnedOriginal = {};
    found.parts.push_back(std::move(part));
  }
  return found;
}

}  // namespace limber
