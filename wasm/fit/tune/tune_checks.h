#pragma once

#include "fit/tune/tune_options.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Throws std::invalid_argument with one sentence where a coarse mesh cannot be tuned to an original: a mesh
// without triangles, more faces than the original, another scale, another place or pose, or a pinned vertex
// that does not exist. Both surfaces may differ by what a coarse mesh must: on average by up to half of its
// mean edge.
void requireTunable(const TriangleMesh& original, const TriangleMesh& result, const TuneOptions& options);

}  // namespace limber
