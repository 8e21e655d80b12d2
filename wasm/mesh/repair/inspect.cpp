#include "mesh/repair/inspect.h"

#include <algorithm>

#include "mesh/manifold.h"
#include "mesh/nesting.h"
#include "mesh/repair/orientation.h"
#include "mesh/topology.h"

namespace limber {

Inspection inspect(const TriangleMesh& mesh) {
  const Topology topology = buildTopology(mesh);
  const auto kinds = classifyVertices(mesh, topology);
  Inspection found;
  found.vertices = mesh.vertexCount();
  found.faces = mesh.triangleCount();
  found.components = topology.componentCount;
  found.solidComponents = countSolidComponents(mesh, topology);
  found.boundaryLoops = countBoundaryLoops(mesh, topology);
  found.eulerCharacteristic =
      int64_t{found.vertices} - static_cast<int64_t>(topology.edges.size()) + int64_t{found.faces};
  found.nonManifoldVertices = static_cast<uint32_t>(std::ranges::count(kinds, VertexKind::NonManifold));
  for (const Topology::Edge& edge : topology.edges) found.nonManifoldEdges += edge.useCount > 2;
  found.orientationClashes = static_cast<uint32_t>(std::ranges::count(topology.clashes, 1));
  const bool manifold = found.nonManifoldEdges == 0 && found.nonManifoldVertices == 0;
  // Each component has chi = 2 - 2 g - b; summed over all components this gives the sum of g.
  if (manifold && (found.orientationClashes == 0 || orient(mesh, topology).orientable))
    found.genus =
        (2 * int64_t{found.components} - int64_t{found.boundaryLoops} - found.eulerCharacteristic) / 2;
  return found;
}

}  // namespace limber
