#pragma once

#include <cstdint>
#include <span>

#include "base/job.h"
#include "mesh/charts.h"
#include "mesh/triangle_mesh.h"
#include "modes/vertex_limits.h"
#include "simplify/history.h"

namespace limber {

struct ModalFitOptions {
  double thickness = 0;  // of the shell, in units of the mesh; fitted at half, once and twice this
  double poisson = 0.3;
  int modeCount = 20;
  Charts charts = {};                    // of the original: no edge is flipped that parts them ...
  bool holdsSeams = true;                // ... and seams stay in place: all, or borders of groups alone
  std::span<const uint8_t> locked = {};  // per vertex of the original: what it has become stays where it is
  // The same, and where they hold a component still, it is its modes when it is held there that are fitted.
  std::span<const uint8_t> pinned = {};
  // Per vertex of the original, see SimplifyConstraints::mirror: a result that is its own image stays one.
  // May be empty.
  std::span<const uint32_t> mirror = {};
  // What holds for `simplified` and shall go on to: distance from the original (units of the mesh) and
  // smallest angle (degrees); where it does not, it gets no worse. 0: no limit.
  double maxDeviation = 0, minAngle = 0;
  // Components with more vertices than that in the result are large: fitted at half and twice the thickness
  // (what lies between follows), in few rounds, and not at all where they had more than this in the original:
  // its frequencies are not known as well as they would have to be then.
  uint32_t largeVertices = kLargeResultVertices, mostOriginal = kRefinedVertices;
  uint32_t coarseVertices =
      kCoarseVertices;  // of a copy of a large result, whose modes are where the search begins
};

// How far the frequencies were off, before and after: root mean square of lambda / lambda_original - 1 over
// all matched modes and thicknesses, halved (so of frequencies), in %; each component's (of two that are
// images of each other the first one's).
struct ModalFitResult {
  MeshAt result;
  std::vector<double> errorBefore, errorAfter;
  uint32_t flips = 0;
  uint32_t large = 0;     // components that were fitted as large ones
  uint32_t tooLarge = 0;  // large components that stay as they are
};

// Moves the vertices of a simplified mesh, by fractions of an edge, so that it vibrates like the original:
// frequencies of the shell at three thicknesses (Fox and Kapoor 1968 sensitivities, Gauss-Newton), in balance
// with the distance from the original's surface. Before that, edges are flipped to Delaunay and vertices
// fitted to the surface. Large components: two thicknesses, and no flips; see largeVertices. Topology and the
// number of faces stay; no face turns; borders, seams, creases and locked vertices stay in place. Works on
// each component. Positions are float32 numbers. Throws Cancelled, and std::invalid_argument where a mirror
// is given and `simplified` is not its own image.
ModalFitResult fitModes(const TriangleMesh& original, const MeshAt& simplified,
                        const ModalFitOptions& options, Job& job);

}  // namespace limber
