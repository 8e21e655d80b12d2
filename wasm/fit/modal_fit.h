#pragma once

#include <cstdint>
#include <vector>

#include "base/job.h"
#include "fit/modal_fit_options.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

struct ModalFitResult {
  MeshAt result;
  // Per fitted component, in the order of their ids (one entry for two components that are mirror images of
  // each other): the root mean square relative error of frequencies over all matched modes and thicknesses
  // before and after the fit, in %.
  std::vector<double> errorBefore, errorAfter;
  uint32_t flips = 0;     // of edges
  uint32_t large = 0;     // components that were fitted as large ones
  uint32_t tooLarge = 0;  // large components that were not fitted
};

// Moves the vertices of a result, by fractions of an edge, so that it vibrates like the original. Over each
// component it minimises, by Levenberg-Marquardt damped Gauss-Newton steps, the weighted sum of
//   (psi_i^T K psi_j / sqrt(lambda_i lambda_j) - delta_ij)^2
// at three thicknesses of the shell, where lambda are eigenvalues of the original, psi modes of the result
// that have been aligned with the original's, and K is the stiffness matrix of the result. Derivatives follow
// Fox and Kapoor 1968. The mean square distance from the original's surface stays within a budget. Before
// that, edges are flipped to Delaunay and vertices are fitted to the surface. Large components are treated
// differently (see ModalFitOptions::largeVertices).
//
// Topology and the number of faces do not change, no face turns over, and borders, seams, creases, flat
// regions and locked vertices keep their shape. Positions are float32 numbers. `result.flips` maps corners to
// those before the flips. A result that still has all faces of the original is returned unchanged. Throws
// Cancelled, and std::invalid_argument if a mirror is given and `result` is not its own mirror image.
ModalFitResult fitModes(const TriangleMesh& original, const MeshAt& result, const ModalFitOptions& options,
                        Job& job);

}  // namespace limber
