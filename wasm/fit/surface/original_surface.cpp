#include "fit/surface/original_surface.h"

#include "fit/surface/sheet_sizes.h"
#include "mesh/topology.h"

namespace limber {

OriginalSurface::OriginalSurface(const TriangleMesh& original, uint32_t count, const EdgeList& featureEdges)
    : tree(original) {
  const Topology topology = buildIncidence(original);
  samples = sampleForFit(original, topology, count, featureEdges);
  sizes = measureSizes(original, topology);
}

}  // namespace limber
