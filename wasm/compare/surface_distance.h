#pragma once

#include "base/job.h"
#include "mesh/triangle_mesh.h"

namespace limber {

struct SurfaceDistanceOptions {
  // Area-uniform sample points per side, in addition to all vertices and to points on the edges. 0: ten per
  // triangle of the finer mesh, within [10,000, 500,000].
  uint32_t samples = 0;
};

// Distances in the units of the meshes.
struct SurfaceDistance {
  double hausdorff = 0;  // symmetric: the largest distance from either side, over all these points
  double mean = 0;       // over the samples, averaged over both sides
  // Symmetric, from vertices to the nearest vertices: what the paper calls Hausdorff distance
  // (docs/paper.md).
  double vertexHausdorff = 0;
};

// Samples are a fixed low-discrepancy sequence, so the result is equal to the last bit for any number of
// threads. O(n log n). All distances are 0 if a mesh has no triangle. Throws Cancelled.
SurfaceDistance measureSurfaceDistance(const TriangleMesh& a, const TriangleMesh& b,
                                       const SurfaceDistanceOptions& options, Job& job);

// Only the field `hausdorff` of measureSurfaceDistance, in a fraction of its time: the exact distance of a
// point is skipped if it cannot exceed the largest one so far. Throws Cancelled.
double measureHausdorff(const TriangleMesh& a, const TriangleMesh& b, const SurfaceDistanceOptions& options,
                        Job& job);

// Whether measureHausdorff would return at most `limit`, in a fraction of its time: the exact distance of a
// point is skipped if it cannot exceed the limit, and the first point beyond it ends the search. Throws
// Cancelled.
bool isWithinHausdorff(const TriangleMesh& a, const TriangleMesh& b, double limit,
                       const SurfaceDistanceOptions& options, Job& job);

}  // namespace limber
