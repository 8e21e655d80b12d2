#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"
#include "simulate/simulation.h"

namespace limber {

// Carries the pins of an original over to a result. Triangles of the original whose three corners are pinned
// make up its pinned region. In the result, each vertex inside this region is pinned, and so are the corners
// of each triangle that lies inside by more than half: the outline of the region is rounded to edges of the
// result, outwards as often as inwards. Pinning points of every triangle that the region touches would leave
// too little of the body free, and pinning only the vertices inside would leave too much. All other pins
// (single ones, rows, and regions too small to contain a triangle) become points of the result, or vertices
// where these coincide.
//
// `pinned`: vertices of the original. `binding`: a point of the result for each vertex of the original, with
// kNone as the triangle if it has none; if empty, closest points at rest are used. An original that is its
// own result keeps its pins. Vertices of the returned pins are unique and ascend. Throws
// std::invalid_argument for a pin that the original does not have, and if a result without triangles is to be
// pinned.
Pins carryPins(const TriangleMesh& original, std::span<const uint32_t> pinned, const TriangleMesh& result,
               std::span<const SurfacePoint> binding = {});

}  // namespace limber
