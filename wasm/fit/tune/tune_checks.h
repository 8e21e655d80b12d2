#pragma once

#include "fit/tune/tune_options.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Throws std::invalid_argument with one sentence if a coarse mesh cannot be tuned to an original: a mesh
// without triangles, more faces than the original, another scale, position or pose, or a pinned vertex that
// does not exist. The surfaces may differ by as much as a coarse mesh necessarily does: on average by up to
// half of its mean edge.
void requireTunable(const TriangleMesh& original, const TriangleMesh& result, const TuneOptions& options);

}  // namespace limber
