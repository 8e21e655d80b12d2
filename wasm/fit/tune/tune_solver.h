#pragma once

#include "base/job.h"
#include "fit/tune/tune_options.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Finds the parameters with which a solver moves a coarse mesh as it moves the original, while the shape of
// the mesh itself is unchanged: masses, and factors on the stiffness of its constraints, so that the lowest
// frequencies are those of the original in the same solver. At rest the stiffness is linear in the factors,
// so the derivatives of all eigenvalues are exact and cost nothing.
//
// Where the original has a border the factors on stretching stay 1, for what hangs is governed by its
// lengths; a global one is tuned as well where a trial of the motion finds that it moves better. Where the
// solver's energy leaves motions without resistance (a flat sheet of springs bends freely, and hinges let
// three sheets swing about an edge that they share), or where no search finds the modes, there are no
// frequencies to fit: factors stay 1, errors are NaN and Tuned::frequencyStatus says which it is. Factors
// keep to [0.1, 10].
//
// With `runsTrial` original and result then move through a short scene, see fit/tune/motion_trial.h, and
// tuned factors are handed over only where the motion is no worse for them by more than its noise.
//
// Both meshes are welded. Throws Cancelled; std::invalid_argument with a sentence where they do not belong
// together, see fit/tune/tune_checks.h, or a constant is out of range; std::runtime_error where memory is
// short.
Tuned tuneSolver(const TriangleMesh& original, const TriangleMesh& result, const TuneOptions& options,
                 Job& job);

}  // namespace limber
