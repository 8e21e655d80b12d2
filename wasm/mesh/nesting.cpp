#include "mesh/nesting.h"

namespace limber {

std::vector<uint32_t> solidHosts(const TriangleMesh& mesh, const Topology& topology) {
  std::vector<uint32_t> host(topology.componentCount);
  for (uint32_t c = 0; c < host.size(); ++c) host[c] = c;
  for (const Topology::Edge& edge : topology.edges)
    if (edge.useCount != 2) host[topology.componentOfVertex[edge.a]] = kNone;
  (void)mesh;
  return host;
}

}  // namespace limber
