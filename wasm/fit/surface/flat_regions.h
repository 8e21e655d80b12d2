#pragma once

#include <Eigen/Dense>
#include <vector>

#include "linear/block_matrix.h"
#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"
#include "query/closest_point.h"

namespace limber {

// Keeps flat regions flat while vertices move. A flat region is a connected set of triangles in one plane
// that contains all triangles around some vertex and over which the original lies in that plane too. The
// vertices of a region, including those of its outline, only move within its plane: a vertex of two regions
// moves along the edge where they meet, and a vertex of three regions does not move. Without this the fit
// leaves dents that are too shallow to matter for a distance but show in the shading.
class FlatRegions {
 public:
  FlatRegions() = default;  // no region
  // `surface`: of the original.
  FlatRegions(const TriangleMesh& original, const ClosestPointTree& surface, const TriangleMesh& mesh,
              const Topology& topology);

  // Adds a large penalty on displacements out of the planes to a quadratic model whose nodes are the
  // vertices.
  void stiffen(BlockMatrix& hessian) const;
  // Removes the components out of the planes from displacements: a column each, of all coordinates.
  void flatten(Eigen::MatrixXd& displacements) const;

 private:
  struct FlatVertex {
    uint32_t vertex;
    Eigen::Matrix3d across;  // orthonormal columns along which it does not move; the rest are 0
  };
  std::vector<FlatVertex> vertices_;
};

}  // namespace limber
