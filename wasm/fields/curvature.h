#pragma once

#include <vector>

#include "base/job.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Absolute mean curvature |(k1 + k2) / 2| in 1 / unit of the mesh. A sphere of radius r has 1 / r.
struct Curvature {
  std::vector<float> vertex;    // Meyer et al. 2003, Eqs. 8 to 10, with mixed areas
  std::vector<float> triangle;  // mean of its three vertices
};

// At borders: the area-weighted mean of the interior neighbours. O(n). Throws Cancelled.
Curvature meanCurvature(const TriangleMesh& mesh, const Topology& topology, Job& job);

}  // namespace limber
