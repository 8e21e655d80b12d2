#pragma once

#include <cstdint>
#include <span>

#include "mesh/charts.h"
#include "mesh/pinned_vertices.h"

namespace limber {

// The options that determine how a result is divided into the parts that a fit works on, and which vertices
// stay in place. They are fields of ModalFitOptions and ShapeFitOptions.
struct FitConstraints {
  Charts charts = {};      // of the original
  bool keepsSeams = true;  // whether all seams between charts stay in place, or only borders of groups
  std::span<const uint8_t> locked = {};  // [v] of the original
  PinnedVertices pinned = {};            // vertices of the original
  uint32_t largeVertices = 0;            // a component of the result with more vertices is large ...
  uint32_t mostOriginal = 0;             // ... and skipped if the original has more than this
};

}  // namespace limber
