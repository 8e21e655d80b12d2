#pragma once

#include <cstdint>
#include <span>

#include "mesh/triangle_mesh.h"
#include "simulate/simulation.h"

namespace limber {

// Pins of one body carried over to another. Triangles whose three corners are pinned make up the held part of
// the surface. Of `other` it holds each vertex that lies in it, and the corners of each triangle more than
// half of which lies in it: so its edge is rounded to the edges of `other`, outwards as often as inwards.
// Points in every pinned place would hold each triangle that the part touches, and leave too little of the
// body free; vertices inside alone would leave too much. All other pins (single ones, lines, and parts too
// small to hold a triangle) become points of `other`, or a vertex where the point is one.
//
// Places are found by `binding` (one point of `other` per vertex of the original, kNone as its triangle where
// it has none), or, where that is empty, as the closest points at rest. Ascending, each vertex once.
Pins carryPins(const TriangleMesh& original, std::span<const uint32_t> pinned, const TriangleMesh& other,
               std::span<const SurfacePoint> binding = {});

}  // namespace limber
