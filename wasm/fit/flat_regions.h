#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Keeps what is flat flat while vertices move. A flat region is what lies in one plane, as the original does
// there, with all triangles around some vertex inside it. Vertices in it, and those of its outline, move
// along its plane alone: between two of them along the edge where they meet, among three not at all. The
// dents that would be left otherwise are too shallow for a distance to tell, but the light shows them.
class FlatRegions {
 public:
  FlatRegions() = default;  // none
  FlatRegions(const TriangleMesh& original, const TriangleMesh& mesh, const Topology& topology);

  // Makes moves out of the planes dear in a quadratic model of all coordinates (3 * v + axis) whose pattern
  // has the blocks of the vertices.
  void hold(Eigen::SparseMatrix<double>& stiffness) const;
  // Takes what leads out of the planes from steps: a column each, of all coordinates.
  void flatten(Eigen::MatrixXd& steps) const;

 private:
  // A vertex and the unit vectors, at right angles, that it does not move along.
  struct Held {
    Eigen::Index first;  // coordinate
    Eigen::Matrix3d across;
  };
  std::vector<Held> held_;
};

}  // namespace limber
