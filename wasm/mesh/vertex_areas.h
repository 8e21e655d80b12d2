#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace limber {

// In squared units of the mesh, summed in the order of the triangles.
double surfaceArea(const TriangleMesh& mesh);

// Per vertex a third of the area of the triangles around it, in squared units of the mesh.
std::vector<double> vertexAreas(const TriangleMesh& mesh);

// The same as lumped masses of unit density: a vertex whose triangles have almost no area gets 1e-9 of the
// mean, because without mass it would vibrate on its own at an arbitrarily high frequency.
std::vector<double> lumpedAreas(const TriangleMesh& mesh);

}  // namespace limber
