#pragma once

#include <vector>

#include "base/job.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// |(k1 + k2) / 2| in 1 / unit of the mesh; a sphere of radius r has 1 / r.
struct Curvature {
  std::vector<float> vertex;    // Meyer et al. 2003, Eqs. 8-10, mixed areas; one-sided at borders
  std::vector<float> triangle;  // the mean of its three vertices
};

Curvature meanCurvature(const TriangleMesh& mesh, const Topology& topology, Job& job);

}  // namespace limber
