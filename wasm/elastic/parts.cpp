#include "elastic/parts.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/component_frame.h"
#include "mesh/nesting.h"

namespace limber {

namespace {

// Per component: the component that hosts it, and its model.
struct Grouping {
  std::vector<uint32_t> host;
  std::vector<ElasticModel> model;
};

Grouping groupComponents(const TriangleMesh& body, const Topology& topology, ElasticModel asked) {
  Grouping grouping;
  grouping.host.resize(topology.componentCount);
  std::iota(grouping.host.begin(), grouping.host.end(), 0u);
  grouping.model.assign(topology.componentCount,
                        asked == ElasticModel::Laplacian ? asked : ElasticModel::Shell);
  if (asked != ElasticModel::Auto && asked != ElasticModel::Solid) return grouping;
  const std::vector<uint32_t> hosts = solidHosts(body, topology);
  for (uint32_t c = 0; c < hosts.size(); ++c) {
    if (hosts[c] != kNone) {
      grouping.host[c] = hosts[c];
      grouping.model[c] = ElasticModel::Solid;
    } else if (asked == ElasticModel::Solid) {
      throw std::invalid_argument(
          "Part " + std::to_string(c + 1) +
          " of the mesh is not closed, so it has no inside for the solid model: close its "
          "holes, or use the model shell or auto.");
    }
  }
  return grouping;
}

// The meshes of the parts in their unit frames, and the ids of their vertices in the body.
void fillParts(std::vector<Part>& parts, MeshParts split, const Topology& topology) {
  for (size_t i = 0; i < parts.size(); ++i) {
    parts[i].mesh = std::move(split.parts[i].mesh);
    parts[i].vertexOfBody = std::move(split.parts[i].vertices);
    for (const uint32_t v : parts[i].vertexOfBody)
      parts[i].componentOfVertex.push_back(topology.componentOfVertex[v]);
    const UnitFrame frame = unitFrame(parts[i].mesh);
    parts[i].diagonal = frame.diagonal;
    moveToFrame(parts[i].mesh, frame);
  }
}

}  // namespace

std::vector<Part> partsOf(const TriangleMesh& body, const Topology& topology, const ModesOptions& options) {
  const Grouping grouping = groupComponents(body, topology, options.model);
  std::vector<Part> parts;
  std::vector<uint32_t> partOf(topology.componentCount);
  for (uint32_t c = 0; c < topology.componentCount; ++c)
    if (grouping.host[c] == c) {
      partOf[c] = static_cast<uint32_t>(parts.size());
      parts.emplace_back().components = {c};
      parts.back().model = grouping.model[c];
    }
  for (uint32_t c = 0; c < topology.componentCount; ++c)
    if (grouping.host[c] != c) {
      partOf[c] = partOf[grouping.host[c]];
      parts[partOf[c]].components.push_back(c);
    }
  std::vector<uint32_t> partOfVertex;
  for (const uint32_t c : topology.componentOfVertex) partOfVertex.push_back(partOf[c]);
  MeshParts split = splitMesh(body, partOfVertex, static_cast<uint32_t>(parts.size()));
  for (uint32_t v : options.pinned) {
    if (v >= body.vertexCount())
      throw std::invalid_argument("Vertex " + std::to_string(v) + " is pinned, but the mesh has only " +
                                  std::to_string(body.vertexCount()) + " vertices.");
    parts[partOfVertex[v]].pinned.push_back(split.localVertex[v]);
  }
  for (Part& part : parts) {
    std::sort(part.pinned.begin(), part.pinned.end());
    part.pinned.erase(std::unique(part.pinned.begin(), part.pinned.end()), part.pinned.end());
  }
  fillParts(parts, std::move(split), topology);
  return parts;
}

}  // namespace limber
