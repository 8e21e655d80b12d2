#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace limber {

// A symmetric matrix over nodes of three unknowns each, as 3 x 3 blocks by rows, both triangles. Row i has
// the blocks blocks[k], k in [start[i], start[i + 1]), at the columns of the nodes column[k]; these ascend,
// and i is among them. With one index for nine numbers it takes a third less memory than a sparse matrix of
// scalars, and products read fewer indices.
struct BlockMatrix {
  std::vector<uint32_t> start, column;
  std::vector<Eigen::Matrix3d> blocks;

  size_t nodeCount() const { return start.size() - 1; }
  // The block of row i at the column of node j; row i must have one. O(blocks of the row).
  Eigen::Matrix3d& at(uint32_t i, uint32_t j);
  const Eigen::Matrix3d& at(uint32_t i, uint32_t j) const { return const_cast<BlockMatrix*>(this)->at(i, j); }
  // Writes the same matrix with scalar entries, zeros included. An output parameter, because sparse matrices
  // of Eigen 3.4 cannot be moved.
  void writeTo(Eigen::SparseMatrix<double>& matrix) const;
};

}  // namespace limber
