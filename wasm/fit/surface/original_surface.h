#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "fit/surface/fit_samples.h"
#include "query/closest_point.h"

namespace limber {

// The surface of a part's original, as results are fitted to it.
struct OriginalSurface {
  // Keeps a reference to the mesh. `samples`: the least number of points of the surface.
  OriginalSurface(const TriangleMesh& original, uint32_t samples, const EdgeList& featureEdges);

  ClosestPointTree tree;
  FitSamples samples;
  Eigen::Vector2d sizes;  // area and length of the outline
};

}  // namespace limber
