#pragma once

#include <cstdint>
#include <span>

#include "base/job.h"
#include "mesh/charts.h"
#include "mesh/pinned_vertices.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

struct ShapeFitOptions {
  Charts charts = {};  // of the original; no edge between two charts is flipped
  // Seams between charts stay in place, too: all of them, or, where this is false, borders of groups alone.
  bool keepsSeams = true;
  std::span<const uint8_t> locked = {};  // [v] of the original: not 0 where what it has become stays in place
  PinnedVertices pinned = {};            // vertices of the original; what they have become stays in place
  // [v] of the original, see SimplifyConstraints::mirror: a result that is its own mirror image stays so. May
  // be empty.
  std::span<const uint32_t> mirror = {};
  // Limits that the result keeps where it respects them before the fit; where it does not, it gets no worse.
  double maxDeviation = 0;  // from the original, in units of the mesh; 0: no limit
  double minAngle = 0;      // degrees; 0: no limit
  uint32_t samples = 0;     // of each surface, at which the deviation is judged; 0: as many as a body needs
};

struct ShapeFitResult {
  MeshAt result;
  uint32_t flips = 0;  // of edges
};

// Flips edges of a result to Delaunay and moves its vertices to where its surface is nearest to the
// original's, in a few rounds over each component. No material, thickness or solver enters, so that what it
// gains holds in all of them. A round solves the least-squares model of the distance (SurfaceFit), under the
// condition that the area becomes the original's as far as that costs no more distance than the round gains.
//
// Topology and the number of faces do not change, and no face turns over. Corners of the outline stay
// where they are, and other vertices of a border stay near it. Seams and flat regions keep their shape;
// locked vertices stay, and so do triangles of the original that collapses have left as they were. Positions
// are float32 numbers. `result.flips` tells where corners come from. A result that still has all faces of the
// original is returned as it is. Throws Cancelled, and std::invalid_argument where a mirror is given and
// `result` is not its own mirror image.
ShapeFitResult fitShape(const TriangleMesh& original, const MeshAt& result, const ShapeFitOptions& options,
                        Job& job);

}  // namespace limber
