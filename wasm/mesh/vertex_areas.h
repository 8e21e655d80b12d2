#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// A third of the area of the triangles around each vertex, in squared units of the mesh. A vertex whose
// triangles have next to no area gets 1e-9 of the mean, so that it cannot vibrate on its own at a wild
// frequency.
std::vector<double> lumpedAreas(const TriangleMesh& mesh);

}  // namespace limber
