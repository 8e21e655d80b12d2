#pragma once

#include <span>

#include "base/job.h"
#include "mesh/triangle_mesh.h"
#include "simplify/constraints.h"
#include "simplify/history.h"

namespace limber {

enum class Method : int32_t { Qem = 0, Paper = 1, Limber = 2 };

struct SimplifyOptions {
  Method method = Method::Paper;
  double strainWeight = 0;     // alpha of Eq. 11
  double curvatureWeight = 0;  // beta
  double qualityWeight = 0;    // gamma
  double sizeWeight = 0;       // of an edge's squared length: qem beside E_QEM, limber as s (0 for paper)
  // Targets; the first one reached ends the history.
  uint32_t stopFaces = 0;  // stops as soon as no more are left
  double maxDeviation =
      0;  // refuses a collapse that takes the surface farther from the input (length); 0: none
  // Degrees; refuses a collapse after which the smallest angle among the triangles it changes is below this
  // without being larger than it was, so that the smallest angle of the mesh never falls below the lesser of
  // this and the input's. 0: none.
  double minAngle = 0;
  SimplifyConstraints constraints{};
};

// What guides `paper`; `limber` takes the strain alone, `qem` nothing. Empty spans count as 0 everywhere.
struct Guidance {
  std::span<const float> strain;     // per triangle, in [0, 1]: rank of the (combined) strain
  std::span<const float> curvature;  // per vertex, in [0, 1]: mean curvature over its maximum
};

// Throws std::invalid_argument where a guidance field or a wish does not fit the mesh, or an option is out of
// its range.
void checkRequest(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options);

// Collapses edges, cheapest first, until no legal edge is left or `stopFaces` are reached, and records every
// step. With `maxDeviation` (see DeviationLimit) or `minAngle` what they refuse is passed over and the rest
// goes on, so that the end of the history is the target, and every mesh of it holds them. qem: area-weighted
// normalised plane quadrics with border quadrics (Garland 1999). paper: Eq. 11 with E_QEM in a frame whose
// bounding diagonal is 300 (Eq. 11 carries no length; see docs/paper.md). Legal: the link condition holds
// (components, boundary loops and genus stay), no face turns over, non-manifold edges and vertices stay
// untouched. A refused edge is tried again when its surroundings change. Ties go to the lower vertex indices.
// An edge whose cost falls when its surroundings change may come late, see CostModel::followsNeighbourhood;
// `paper` with a quality weight never lets it.
// Throws Cancelled, and std::invalid_argument where a guidance field has the wrong size.
History simplify(const TriangleMesh& mesh, const Guidance& guidance, const SimplifyOptions& options,
                 Job& job);

}  // namespace limber
