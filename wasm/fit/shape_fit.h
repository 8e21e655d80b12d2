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
  // Whether all seams between charts stay in place; if false, only borders of groups do.
  bool keepsSeams = true;
  std::span<const uint8_t> locked = {};  // [v] of the original: not 0 if its vertex of the result is fixed
  PinnedVertices pinned = {};            // vertices of the original; those of the result stay in place
  // [v] of the original, see SimplifyConstraints::mirror: a result that is its own mirror image remains
  // symmetric. May be empty.
  std::span<const uint32_t> mirror = {};
  // Limits. If the result respects a limit before the fit, it still does afterwards; otherwise it gets no
  // worse.
  double maxDeviation = 0;  // from the original, in units of the mesh; 0: no limit
  double minAngle = 0;      // degrees; 0: no limit
  uint32_t samples = 0;     // of each surface, at which the deviation is measured; 0: kGuardSamples
};

struct ShapeFitResult {
  MeshAt result;
  uint32_t flips = 0;  // of edges
};

// Flips edges of a result to Delaunay and moves its vertices so that its surface is nearest to the
// original's, in a few rounds over each component. It does not depend on material, thickness or solver, so
// its gains hold for all of them. A round solves the least-squares model of the distance (SurfaceFit), under
// the condition that the area approaches the original's as far as that costs no more distance than the round
// gains.
//
// Topology and the number of faces do not change, and no face turns over. Corners of the outline stay
// where they are, and other vertices of a border stay near it. Seams and flat regions keep their shape;
// locked vertices stay in place, and so do triangles of the original that no collapse has changed. Positions
// are float32 numbers. `result.flips` maps corners to those before the flips. A result that still has all
// faces of the original is returned unchanged. Throws Cancelled, and std::invalid_argument if a mirror is
// given and `result` is not its own mirror image.
ShapeFitResult fitShape(const TriangleMesh& original, const MeshAt& result, const ShapeFitOptions& options,
                        Job& job);

}  // namespace limber
