#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/job.h"
#include "fit/tuning.h"
#include "mesh/charts.h"
#include "mesh/pinned_vertices.h"
#include "mesh/triangle_mesh.h"
#include "modes/find_modes.h"
#include "simplify/history.h"

namespace limber {

struct ModalFitOptions {
  double thickness = 0;  // of the shell, in units of the mesh; the fit compares at half, once and twice this
  double poisson = 0.3;
  int modeCount = 20;
  Charts charts = {};  // of the original; no edge between two charts is flipped
  // Seams between charts stay in place, too: all of them, or, where this is false, borders of groups alone.
  bool keepsSeams = true;
  std::span<const uint8_t> locked = {};  // [v] of the original: not 0 where what it has become stays in place
  // Vertices of the original. What they have become stays in place; where they leave a component no rigid
  // motion, its modes with these vertices pinned are fitted.
  PinnedVertices pinned = {};
  // [v] of the original, see SimplifyConstraints::mirror: a result that is its own mirror image stays so. May
  // be empty.
  std::span<const uint32_t> mirror = {};
  // Limits that the result keeps where it respects them before the fit; where it does not, it gets no worse.
  double maxDeviation = 0;  // from the original, in units of the mesh; 0: no limit
  double minAngle = 0;      // degrees; 0: no limit
  // Components with more vertices than this in the result are large: they are fitted at half and twice the
  // thickness alone, in few rounds, without flips.
  uint32_t largeVertices = tuning::large::kVertices;
  // Large components with more vertices than this in the original are not fitted: their frequencies are not
  // known as precisely as a fit would need.
  uint32_t mostOriginal = kRefinedVertices;
  uint32_t coarseVertices = tuning::large::kCoarseVertices;  // see ModalTargetOptions
};

struct ModalFitResult {
  MeshAt result;
  // Per fitted component, in the order of their ids (one entry for two components that are mirror images of
  // each other): the root mean square relative error of frequencies over all matched modes and thicknesses,
  // in
  // %, before and after the fit.
  std::vector<double> errorBefore, errorAfter;
  uint32_t flips = 0;     // of edges
  uint32_t large = 0;     // components that were fitted as large ones
  uint32_t tooLarge = 0;  // large components that were left as they are
};

// Moves the vertices of a result, by fractions of an edge, so that it vibrates like the original. Over each
// component it minimises, by Levenberg-Marquardt damped Gauss-Newton steps, the weighted sum of
//   (psi_i^T K psi_j / sqrt(lambda_i lambda_j) - delta_ij)^2
// at three thicknesses of the shell, where lambda are eigenvalues of the original, psi modes of the result
// that have been aligned with the original's, and K is the stiffness matrix of the result; their derivatives
// are those of Fox and Kapoor 1968. The mean square distance from the original's surface stays within a
// budget. Before that, edges are flipped to Delaunay and vertices are fitted to the surface; large components
// are treated differently (see ModalFitOptions::largeVertices).
//
// Topology and the number of faces do not change, no face turns over, and borders, seams, creases, flat
// regions and locked vertices keep their shape. Positions are float32 numbers. `result.flips` tells where
// corners come from. A result that still has all faces of the original is returned as it is. Throws
// Cancelled, and std::invalid_argument where a mirror is given and `result` is not its own mirror image.
ModalFitResult fitModes(const TriangleMesh& original, const MeshAt& result, const ModalFitOptions& options,
                        Job& job);

}  // namespace limber
