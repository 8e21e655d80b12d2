#pragma once

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

struct SurfaceDistanceOptions {
  uint32_t samples = 0;  // area-uniform points per side, besides all vertices; 0: ten per triangle of the
                         // finer mesh, within [10,000, 500,000]
};

// Distances in the units of the meshes.
struct SurfaceDistance {
  double hausdorff = 0;  // symmetric: the larger of both sides' largest distance, over samples and vertices
  double mean = 0;       // mean over area-uniform samples, mean of both sides
  double vertexHausdorff =
      0;  // symmetric, from vertices to the nearest vertices (the paper's "Hausdorff", docs/paper.md)
};

// Sampled with a fixed low-discrepancy sequence: the same meshes give the same bits, on any number of
// threads.
SurfaceDistance measureSurfaceDistance(const TriangleMesh& a, const TriangleMesh& b,
                                       const SurfaceDistanceOptions& options, Job& job);

}  // namespace limber
