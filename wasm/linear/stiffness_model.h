#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace limber {

// What a model hands to the solver: K (both triangles stored) and the diagonal of M, whose entries may be 0
// (massless unknowns). Unknowns come in nodes: node i has the unknowns firstUnknown[i] .. firstUnknown[i +
// 1), which are coupled alike, zeros stored where need be. Nodes with fewer unknowns than others should lie
// between those (as a rotation of an edge does between its vertices): the order of elimination is found on
// the others alone.
struct StiffnessModel {
  Eigen::SparseMatrix<double> stiffness;
  Eigen::VectorXd mass;
  std::vector<uint32_t> firstUnknown;

  uint32_t nodeCount() const { return static_cast<uint32_t>(firstUnknown.size() - 1); }
  uint32_t unknownCount() const { return static_cast<uint32_t>(mass.size()); }
};

}  // namespace limber
