#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/charts.h"
#include "mesh/topology.h"
#include "simplify/history.h"

namespace limber {

// The surroundings of every vertex of a result on its input, parted along seams. The cluster of a vertex is
// the input vertices that have become it, its corners are those of the triangles around them.
class ChartSides {
 public:
  ChartSides(const TriangleMesh& input, const Topology& topology, const Charts& charts, const MeshAt& result);

  bool isSeam(uint32_t edge) const { return isSeam_[edge] != 0; }
  // How many seams meet at a vertex of the input: 0 within a chart, 2 along a seam.
  uint32_t seamCount(uint32_t vertex) const { return seamCount_[vertex]; }
  // The side of an input corner: the flat index of the lowest corner of its cluster that is joined to it
  // without crossing a seam.
  uint32_t sideOf(Corner corner) const { return side_[corner.flatIndex()]; }
  // The input corners around vertex v of the result, ascending.
  std::span<const Corner> cornersAround(uint32_t v) const {
    return {corners_.data() + firstCorner_[v], firstCorner_[v + 1] - firstCorner_[v]};
  }

 private:
  void findSeams(const TriangleMesh& input, const Topology& topology, const Charts& charts);
  void joinCorners(const TriangleMesh& input, const Topology& topology,
                   const std::vector<uint32_t>& vertexOfInput);
  void sortCorners(const TriangleMesh& input, const MeshAt& result);

  std::vector<uint8_t> isSeam_;        // per edge
  std::vector<uint32_t> seamCount_;    // per vertex of the input
  std::vector<uint32_t> side_;         // per corner
  std::vector<uint32_t> firstCorner_;  // per vertex of the result, and the end
  std::vector<Corner> corners_;
};

}  // namespace limber
