#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace limber {

// What a model hands to the solver: K (both triangles stored) and the diagonal of M, whose entries may be 0
// (massless unknowns). Unknowns come in nodes, points in space that carry one or more of them: node i has the
// unknowns firstUnknown[i] .. firstUnknown[i + 1).
struct StiffnessModel {
  Eigen::SparseMatrix<double> stiffness;
  Eigen::VectorXd mass;
  std::vector<Vec3> nodes;
  std::vector<uint32_t> firstUnknown;

  uint32_t nodeCount() const { return static_cast<uint32_t>(nodes.size()); }
  uint32_t unknownCount() const { return static_cast<uint32_t>(mass.size()); }
};

}  // namespace limber
