#pragma once

#include <cstdint>
#include <span>

#include "fit/fit_constraints.h"
#include "mesh/charts.h"
#include "mesh/pinned_vertices.h"
#include "modes/vertex_limits.h"

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
  uint32_t largeVertices = kLargeResultVertices;
  // Large components with more vertices than this in the original are not fitted: their frequencies are not
  // known as precisely as a fit would need.
  uint32_t mostOriginal = kRefinedVertices;
  uint32_t coarseVertices = kCoarseVertices;  // see ModalTargetOptions

  FitConstraints constraints() const {
    return {charts, keepsSeams, locked, pinned, largeVertices, mostOriginal};
  }
};

}  // namespace limber
