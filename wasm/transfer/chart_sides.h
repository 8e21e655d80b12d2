#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/charts.h"
#include "mesh/topology.h"
#include "simplify/history.h"

namespace limber {

// The corners of the original around every vertex of a result, divided along seams. The cluster of a vertex
// of the result consists of the vertices of the original that were merged into it; its corners are those of
// the triangles of the original around them. They are divided into sides: sets of corners that are connected
// without crossing a seam.
class ChartSides {
 public:
  // `topology`: of the original. If the lists of `charts` are empty, the borders of the original are the only
  // seams. `result.vertexOfInput` refers to the original.
  ChartSides(const TriangleMesh& original, const Topology& topology, const Charts& charts,
             const MeshAt& result);

  bool isSeam(uint32_t edge) const { return isSeam_[edge] != 0; }
  // The number of seams that meet at a vertex of the original: 0 within a chart, 2 along a seam.
  uint32_t seamCount(uint32_t vertex) const { return seamCount_[vertex]; }
  // The side of a corner of the original, identified by the flat index of its lowest corner.
  uint32_t sideOf(Corner corner) const { return side_[corner.flatIndex()]; }
  // The corners of the original around vertex v of the result, ascending.
  std::span<const Corner> cornersAround(uint32_t v) const {
    return {corners_.data() + firstCorner_[v], firstCorner_[v + 1] - firstCorner_[v]};
  }

 private:
  void findSeams(const TriangleMesh& original, const Topology& topology, const Charts& charts);
  void joinCorners(const TriangleMesh& original, const Topology& topology,
                   const std::vector<uint32_t>& vertexOfInput);
  void sortCorners(const TriangleMesh& original, const MeshAt& result);

  std::vector<uint8_t> isSeam_;        // per edge
  std::vector<uint32_t> seamCount_;    // per vertex of the original
  std::vector<uint32_t> side_;         // [3 t + c] of the original
  std::vector<uint32_t> firstCorner_;  // per vertex of the result, and the end
  std::vector<Corner> corners_;
};

}  // namespace limber
