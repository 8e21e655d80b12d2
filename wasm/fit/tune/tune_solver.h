#pragma once

#include "base/job.h"
#include "fit/tune/tune_options.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Finds the parameters with which a solver moves a coarse mesh as it moves the original, without changing the
// shape of the mesh: masses, and factors on the stiffness of its constraints, so that the lowest frequencies
// are those of the original in the same solver. At rest the stiffness is linear in the factors, so the
// derivatives of all eigenvalues are exact and cheap.
//
// If the original has a border, the factors on stretching stay 1, because the lengths of a hanging sheet
// govern its motion; a global stretch factor is tuned as well if a motion trial finds that it improves
// the motion. If the solver's energy leaves motions without resistance (a flat sheet of springs bends freely,
// and hinges let three sheets swing about a shared edge), or if no search finds the modes, there are no
// frequencies to fit: factors stay 1, errors are NaN and Tuned::frequencyStatus has the reason. Factors stay
// in [0.1, 10]; those on bending may go beyond by what the resolution alone asks for, see
// fit/tune/steps/factor_range.h.
//
// With `runsTrial` original and result then move through a short scene, see fit/tune/motion_trial.h, and
// tuned factors are returned only if they do not worsen the motion by more than its noise floor. Without a
// motion they are returned only if they do not worsen the fitted frequencies: a fit of logarithms, which a
// few modes that are far off dominate, can do so.
//
// Both meshes must be welded. Throws Cancelled; std::invalid_argument with a sentence if they do not belong
// together, see fit/tune/tune_checks.h, or a constant is out of range; std::runtime_error if memory is short.
Tuned tuneSolver(const TriangleMesh& original, const TriangleMesh& result, const TuneOptions& options,
                 Job& job);

}  // namespace limber
