#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace limber {

// A symmetric matrix pencil (K, M) of the eigenproblem K phi = lambda M phi: K sparse and positive
// semidefinite, M diagonal with entries >= 0. Unknowns without an entry in M are called massless.
//
// The unknowns are grouped into nodes: node i has the unknowns firstUnknown[i] .. firstUnknown[i + 1) - 1.
// All unknowns of a node have the same pattern in K, so zeros are stored where necessary. Nodes with fewer
// unknowns than the largest ones should couple only such large nodes that are coupled with each other anyway
// (as an edge of a mesh couples its two vertices), because the elimination order is only computed for the
// large nodes.
struct SparsePencil {
  Eigen::SparseMatrix<double> k;       // both triangles are stored, equal to the last bit
  Eigen::VectorXd m;                   // the diagonal of M
  std::vector<uint32_t> firstUnknown;  // nodeCount + 1 entries, ascending from 0

  uint32_t nodeCount() const { return static_cast<uint32_t>(firstUnknown.size() - 1); }
  uint32_t unknownCount() const { return static_cast<uint32_t>(m.size()); }
  // Whether an unknown is coupled to another one. Pinned unknowns are not.
  bool isCoupled(Eigen::Index unknown) const {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(k, unknown); entry; ++entry)
      if (entry.row() != unknown && entry.value() != 0) return true;
    return false;
  }
};

}  // namespace limber
