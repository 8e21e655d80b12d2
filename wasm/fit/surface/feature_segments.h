#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Edges by their vertices, the smaller one first; sorted.
using EdgeList = std::vector<std::array<uint32_t, 2>>;

// The borders and feature edges of a mesh as triangles (a, b, b) without area, so that the search for closest
// points on surfaces finds the closest such edge.
struct FeatureSegments {
  TriangleMesh segments;
  std::vector<uint32_t> triangle;          // per segment: the triangle of the mesh that has the edge
  std::vector<std::array<int, 2>> corner;  // per segment: the corners (0, 1 or 2) of that triangle at a and b
};

// `featureEdges`: interior edges that count in addition to the borders; null if there are none.
FeatureSegments featureSegments(const TriangleMesh& mesh, const Topology& topology,
                                const EdgeList* featureEdges);

}  // namespace limber
