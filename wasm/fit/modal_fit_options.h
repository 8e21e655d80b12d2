#pragma once

#include <cstdint>
#include <span>

#include "fit/fit_constraints.h"
#include "mesh/charts.h"
#include "mesh/pinned_vertices.h"
#include "modes/vertex_limits.h"

namespace limber {

struct ModalFitOptions {
  double thickness = 0;  // of the shell, in units of the mesh; the fit compares at 0.5, 1 and 2 times this
  double poisson = 0.3;
  int modeCount = 20;
  Charts charts = {};  // of the original; no edge between two charts is flipped
  // Whether all seams between charts stay in place; if false, only borders of groups do.
  bool keepsSeams = true;
  std::span<const uint8_t> locked = {};  // [v] of the original: not 0 if its vertex of the result is fixed
  // Vertices of the original. Their vertices of the result stay in place. If they leave a component no rigid
  // motion, its modes with these vertices pinned are fitted.
  PinnedVertices pinned = {};
  // [v] of the original, see SimplifyConstraints::mirror: a result that is its own mirror image remains
  // symmetric. May be empty.
  std::span<const uint32_t> mirror = {};
  // Limits. If the result respects a limit before the fit, it still does afterwards; otherwise it gets no
  // worse.
  double maxDeviation = 0;  // from the original, in units of the mesh; 0: no limit
  double minAngle = 0;      // degrees; 0: no limit
  // Components with more vertices than this in the result are large: they are fitted only at half and twice
  // the thickness, in few rounds, without flips.
  uint32_t largeVertices = kLargeResultVertices;
  // Large components with more vertices than this in the original are not fitted, because their frequencies
  // are not known precisely enough.
  uint32_t mostOriginal = kRefinedVertices;
  uint32_t coarseVertices = kCoarseVertices;  // see ModalTargetOptions

  FitConstraints constraints() const {
    return {charts, keepsSeams, locked, pinned, largeVertices, mostOriginal};
  }
};

}  // namespace limber
