#pragma once

#include <Eigen/Core>

namespace limber {

// A view of matrix entries at constant strides: a block, a map, or the transpose of either.
// Entry (i, j) is data[i * rowStride + j * colStride].
template <class Scalar>
struct Strided {
  Scalar* data;
  Eigen::Index rows, cols, rowStride, colStride;

  Strided transpose() const { return {data, cols, rows, colStride, rowStride}; }
};

template <class Matrix>
auto strided(Matrix& matrix) {
  const Eigen::Index inner = matrix.innerStride(), outer = matrix.outerStride();
  return Strided<std::remove_pointer_t<decltype(matrix.data())>>{matrix.data(), matrix.rows(), matrix.cols(),
                                                                 Matrix::IsRowMajor ? outer : inner,
                                                                 Matrix::IsRowMajor ? inner : outer};
}

// c -= a b, on one thread. Neither a nor b may share memory with c. The terms of each entry are summed in the
// order of a's columns, in blocks of 256.
void subtractStridedProduct(const Strided<const double>& a, const Strided<const double>& b,
                            const Strided<double>& c);

// The same for Eigen's matrices, blocks and maps. In WebAssembly this is twice as fast as the product of
// Eigen 3.4, which has no SIMD kernel for it.
template <class A, class B, class C>
void subtractProduct(const A& a, const B& b, C&& c) {
  subtractStridedProduct(strided(a), strided(b), strided(c));
}

// The same for the lower part of c, below its diagonal and on it. c has unit row stride. Entries above the
// diagonal are either subtracted from or left as they are.
void subtractLowerStridedProduct(const Strided<const double>& a, const Strided<const double>& b,
                                 const Strided<double>& c);
template <class A, class B, class C>
void subtractLowerProduct(const A& a, const B& b, C&& c) {
  subtractLowerStridedProduct(strided(a), strided(b), strided(c));
}

// a b.
template <class A, class B>
Eigen::MatrixXd product(const A& a, const B& b) {
  Eigen::MatrixXd negative = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  subtractProduct(a, b, negative);
  return -negative;
}

}  // namespace limber
