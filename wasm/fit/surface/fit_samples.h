#pragma once

#include <cstdint>
#include <vector>

#include "fit/surface/feature_segments.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// The samples that a result is fitted to: points of the original, each with its normal and the area that it
// represents, and points of the original's borders and feature edges, each with its direction and the length
// that it represents. In units of the mesh.
struct FitSamples {
  struct OnSurface {
    Vec3 point, normal;  // the normal has length 1
    double area;
  };
  struct OnFeature {
    Vec3 point, tangent;  // the tangent has length 1
    double length;
  };
  std::vector<OnSurface> surface;
  std::vector<OnFeature> features;
};

// At least `count` points of the surface, about `count` / n on each of its n triangles that have area, evenly
// within it. Triangles larger than the mean get proportionally more: otherwise a few points would represent a
// large flat side, whose corners, far from all of them, would be free to move.
FitSamples sampleForFit(const TriangleMesh& original, const Topology& topology, uint32_t count,
                        const EdgeList& featureEdges);

}  // namespace limber
