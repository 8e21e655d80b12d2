#pragma once

#include <cstdint>
#include <span>

#include "simplify/constraints.h"
#include "simplify/method.h"

namespace limber {

struct SimplifyOptions {
  Method method = Method::Paper;
  double strainWeight = 0;  // >= 0; paper: alpha of Eq. 11; limber: w, the weight of strain in the size cost
  double curvatureWeight = 0;  // >= 0; paper: beta of Eq. 11
  double qualityWeight = 0;    // >= 0; paper: gamma of Eq. 11; limber: g, the weight of the worst triangle
  double sizeWeight = 0;       // >= 0; qem and limber: the weight of the squared length of an edge
  // Targets; the first one that is reached ends the history.
  uint32_t stopFaces = 0;  // ends as soon as no more than this many triangles are left
  // Refuses collapses that move the surface farther from the input than this length; 0: no limit.
  double maxDeviation = 0;
  // Degrees, in [0, 60). Refuses a collapse after which the smallest angle among the triangles that it
  // changes is below this and no larger than it was. The smallest angle of the mesh therefore never falls
  // below the smaller of this and that of the input. 0: no limit.
  double minAngle = 0;
  // Whether the history records an estimate of the deviation after each collapse, see History::errors.
  bool recordErrors = false;
  // Collapses that are estimated to move the surface farther from the input than this length are deferred
  // until no other is left; then this length doubles. Beyond it, distance is therefore never traded for size,
  // quality or strain. 0: none is deferred.
  double deferBeyond = 0;
  SimplifyConstraints constraints{};
};

// The fields that guide `paper`; `limber` only uses the strain, `qem` neither. An empty span counts as 0
// everywhere.
struct Guidance {
  std::span<const float> strain;     // per triangle, in [0, 1]: rank of the (combined) strain
  std::span<const float> curvature;  // per vertex, in [0, 1]: mean curvature over its maximum
};

}  // namespace limber
