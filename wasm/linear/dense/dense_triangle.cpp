#include "linear/dense/dense_triangle.h"

#include <algorithm>

#include "linear/dense/dense_product.h"

namespace limber {

namespace {

constexpr Eigen::Index kBlock = 16;  // rows that are solved one at a time before the next update

// Solves with the diagonal block of rows start .. end - 1, for a single vector y.
void solveBlock(const UnitLower& lower, Eigen::Index start, Eigen::Index end, double* y) {
  for (Eigen::Index j = start; j < end; ++j) {
    const double* column = &lower.coeffRef(0, j);
    for (Eigen::Index i = j + 1; i < end; ++i) y[i] -= column[i] * y[j];
  }
}

void solveBlockTransposed(const UnitLower& lower, Eigen::Index start, Eigen::Index end, double* y) {
  for (Eigen::Index j = end; j-- > start;) {
    const double* column = &lower.coeffRef(0, j);
    for (Eigen::Index i = j + 1; i < end; ++i) y[j] -= column[i] * y[i];
  }
}

bool isVector(const RightSides& y) {
  return y.cols() == 1 && y.outerStride() == 1;
}

}  // namespace

void solveLower(const UnitLower& lower, RightSides y) {
  const Eigen::Index size = lower.cols();
  for (Eigen::Index start = 0; start < size; start += kBlock) {
    const Eigen::Index end = std::min(size, start + kBlock);
    if (isVector(y))
      solveBlock(lower, start, end, y.data());
    else
      for (Eigen::Index j = start; j < end; ++j)
        for (Eigen::Index i = j + 1; i < end; ++i) y.row(i) -= lower(i, j) * y.row(j);
    if (end < size)
      subtractProduct(lower.block(end, start, size - end, end - start), y.middleRows(start, end - start),
                      y.middleRows(end, size - end));
  }
}

void solveLowerTransposed(const UnitLower& lower, RightSides y) {
  const Eigen::Index size = lower.cols();
  for (Eigen::Index end = size; end > 0;) {
    const Eigen::Index start = (end - 1) / kBlock * kBlock;
    if (end < size)
      subtractProduct(lower.block(end, start, size - end, end - start).transpose(),
                      y.middleRows(end, size - end), y.middleRows(start, end - start));
    if (isVector(y))
      solveBlockTransposed(lower, start, end, y.data());
    else
      for (Eigen::Index i = end; i-- > start;)
        for (Eigen::Index j = start; j < i; ++j) y.row(j) -= lower(i, j) * y.row(i);
    end = start;
  }
}

}  // namespace limber
