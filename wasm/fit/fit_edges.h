#pragma once

#include "fit/fit_constraints.h"
#include "fit/result_mirror.h"
#include "fit/surface/feature_segments.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "simplify/history.h"

namespace limber {

// Edges that a fit has to respect, by vertices of the whole original and the whole result.
struct FitEdges {
  EdgeList original, result;  // seams that stay in place, of both meshes
  EdgeList fixed;  // edges of the result that are not flipped: all its seams and their mirror images
};

// `topology`: of the original. `mirror`: null if the result is not its own mirror image.
struct FitEdgesInput {
  const TriangleMesh& original;
  const Topology& topology;
  const MeshAt& result;
  const ResultMirror* mirror;
};
FitEdges findFitEdges(const FitEdgesInput& input, const FitConstraints& constraints);

}  // namespace limber
