#include "elastic/parts.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

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

// Hands the vertices of the body to the parts. Returns, per vertex of the body, its id in its part.
std::vector<uint32_t> addVertices(const TriangleMesh& body, const Topology& topology,
                                  const std::vector<uint32_t>& partOfComponent, std::vector<Part>& parts) {
  std::vector<uint32_t> local(body.vertexCount());
  for (uint32_t v = 0; v < body.vertexCount(); ++v) {
    Part& part = parts[partOfComponent[topology.componentOfVertex[v]]];
    local[v] = part.mesh.vertexCount();
    part.mesh.positions.push_back(body.positions[v]);
    part.vertexOfBody.push_back(v);
    part.componentOfVertex.push_back(topology.componentOfVertex[v]);
  }
  return local;
}

void scaleToFrame(Part& part) {
  const Bounds box = bounds(part.mesh);
  part.diagonal = box.diagonal() > 0 ? box.diagonal() : 1;
  for (Vec3& p : part.mesh.positions) p = (p - box.low) / part.diagonal;
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
  const std::vector<uint32_t> local = addVertices(body, topology, partOf, parts);
  const auto partOfVertex = [&](uint32_t v) -> Part& { return parts[partOf[topology.componentOfVertex[v]]]; };
  for (const Triangle& t : body.triangles)
    partOfVertex(t[0]).mesh.triangles.push_back({local[t[0]], local[t[1]], local[t[2]]});
  for (uint32_t v : options.pinned) {
    if (v >= body.vertexCount())
      throw std::invalid_argument("Vertex " + std::to_string(v) + " is pinned, but the mesh has only " +
                                  std::to_string(body.vertexCount()) + " vertices.");
    partOfVertex(v).pinned.push_back(local[v]);
  }
  for (Part& part : parts) {
    std::sort(part.pinned.begin(), part.pinned.end());
    part.pinned.erase(std::unique(part.pinned.begin(), part.pinned.end()), part.pinned.end());
    scaleToFrame(part);
  }
  return parts;
}

}  // namespace limber
