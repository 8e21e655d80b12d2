#include "linear/block_matrix.h"

#include <algorithm>

namespace limber {

Eigen::Matrix3d& BlockMatrix::at(uint32_t i, uint32_t j) {
  const auto first = column.begin() + start[i], last = column.begin() + start[i + 1];
  return blocks[static_cast<size_t>(std::find(first, last, j) - column.begin())];
}

// Row i of blocks is column i of the symmetric matrix, transposed.
void BlockMatrix::writeTo(Eigen::SparseMatrix<double>& matrix) const {
  const auto size = 3 * static_cast<Eigen::Index>(nodeCount());
  matrix.resize(size, size);
  matrix.resizeNonZeros(9 * static_cast<Eigen::Index>(blocks.size()));
  int* const outer = matrix.outerIndexPtr();
  int* inner = matrix.innerIndexPtr();
  double* value = matrix.valuePtr();
  for (uint32_t i = 0; i < nodeCount(); ++i)
    for (uint32_t c = 0; c < 3; ++c) {
      outer[3 * i + c] = static_cast<int>(value - matrix.valuePtr());
      for (uint32_t k = start[i]; k < start[i + 1]; ++k)
        for (uint32_t r = 0; r < 3; ++r) {
          *inner++ = static_cast<int>(3 * column[k] + r);
          *value++ = blocks[k](c, r);
        }
    }
  outer[size] = static_cast<int>(value - matrix.valuePtr());
}

}  // namespace limber
