#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "linear/dense/dense_product.h"
#include "linear/dense/dense_triangle.h"

namespace limber {
namespace {

using ColumnMajor = Eigen::MatrixXd;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Numbers between -1 and 1 that are the same on every machine.
template <class Matrix>
Matrix numbers(Eigen::Index rows, Eigen::Index cols, double seed) {
  Matrix matrix(rows, cols);
  for (Eigen::Index i = 0; i < rows; ++i)
    for (Eigen::Index j = 0; j < cols; ++j)
      matrix(i, j) = std::sin(seed + 1.7 * static_cast<double>(i) + 0.9 * static_cast<double>(j * j));
  return matrix;
}

// c - a b, entry by entry.
template <class C, class A, class B>
ColumnMajor expected(const C& c, const A& a, const B& b) {
  ColumnMajor result = c;
  for (Eigen::Index i = 0; i < c.rows(); ++i)
    for (Eigen::Index j = 0; j < c.cols(); ++j) {
      long double sum = 0;
      for (Eigen::Index k = 0; k < a.cols(); ++k) sum += static_cast<long double>(a(i, k)) * b(k, j);
      result(i, j) -= static_cast<double>(sum);
    }
  return result;
}

template <class C, class A, class B>
void checkProduct(const A& a, const B& b) {
  C c = numbers<C>(a.rows(), b.cols(), 3);
  const ColumnMajor wanted = expected(c, a, b);
  subtractProduct(a, b, c);
  if (c.size() == 0) return;
  const double scale = 1 + static_cast<double>(a.cols());
  EXPECT_LE((c - wanted).cwiseAbs().maxCoeff(), 1e-15 * scale)
      << a.rows() << " x " << a.cols() << " times " << b.rows() << " x " << b.cols();
}

struct Sizes {
  Eigen::Index rows, depth, cols;
};

// Below, at and beyond the tiles (4), the blocks (64 rows, 96 columns) and the depth (256) of the kernel.
constexpr Sizes kSizes[] = {{1, 1, 1},     {3, 2, 1},       {4, 4, 4},   {5, 3, 6},   {64, 256, 96},
                            {67, 257, 97}, {130, 300, 193}, {2, 600, 2}, {1, 40, 30}, {30, 40, 1},
                            {31, 9, 1},    {0, 3, 2},       {3, 0, 2},   {3, 2, 0},   {200, 1, 5}};

TEST(DenseProduct, OfTheLowerPartIsThatOfItsEntriesToTheBit) {
  for (const auto [rows, depth, cols] : kSizes) {
    const auto a = numbers<ColumnMajor>(rows, depth, 1);
    const auto b = numbers<ColumnMajor>(depth, cols, 2);
    ColumnMajor whole = numbers<ColumnMajor>(rows, cols, 3), lower = whole;
    subtractProduct(a, b, whole);
    subtractLowerProduct(a, b, lower);
    const double scale = cols == 1 ? 1e-15 * (1 + static_cast<double>(depth)) : 0;
    for (Eigen::Index j = 0; j < cols; ++j)
      for (Eigen::Index i = j; i < rows; ++i)
        EXPECT_NEAR(lower(i, j), whole(i, j), scale) << rows << " x " << cols;
  }
}

TEST(DenseProduct, IsThatOfItsEntriesInEveryStorageOrder) {
  for (const auto [rows, depth, cols] : kSizes) {
    const auto a = numbers<ColumnMajor>(rows, depth, 1);
    const auto b = numbers<ColumnMajor>(depth, cols, 2);
    const RowMajor aRows = a, bRows = b;
    checkProduct<ColumnMajor>(a, b);
    checkProduct<ColumnMajor>(aRows, b);
    checkProduct<ColumnMajor>(a, bRows);
    checkProduct<RowMajor>(a, b);
    checkProduct<RowMajor>(aRows, bRows);
  }
}

TEST(DenseProduct, TakesTransposesAndBlocksAndLeavesTheRestAlone) {
  const auto big = numbers<ColumnMajor>(120, 90, 1);
  const auto other = numbers<RowMajor>(110, 80, 2);
  for (const auto [rows, depth, cols] : kSizes) {
    if (rows > 80 || depth > 100 || cols > 70) continue;
    const auto a = big.block(7, 3, depth, rows).transpose();
    const auto b = other.block(5, 4, depth, cols);
    auto frame = numbers<ColumnMajor>(rows + 9, cols + 5, 4);
    const ColumnMajor before = frame;
    ColumnMajor wanted = before;
    wanted.block(2, 3, rows, cols) = expected(before.block(2, 3, rows, cols), a, b);
    subtractProduct(a, b, frame.block(2, 3, rows, cols));
    EXPECT_LE((frame - wanted).cwiseAbs().maxCoeff(), 1e-13);
    frame.block(2, 3, rows, cols) = before.block(2, 3, rows, cols);
    EXPECT_EQ(frame, before);
  }
}

TEST(DenseProduct, IsTheSameInBothStorageOrdersToTheLastBit) {
  const auto a = numbers<ColumnMajor>(70, 300, 1);
  const auto b = numbers<ColumnMajor>(300, 50, 2);
  ColumnMajor columns = ColumnMajor::Zero(70, 50);
  RowMajor rows = RowMajor::Zero(70, 50);
  subtractProduct(a, b, columns);
  subtractProduct(a, b, rows);
  EXPECT_EQ(columns, ColumnMajor(rows));
  EXPECT_EQ(product(a, b), -columns);
}

// Entries on and above the diagonal must not be read.
ColumnMajor triangle(Eigen::Index size) {
  ColumnMajor lower = 0.3 * numbers<ColumnMajor>(size + 4, size, 1);
  for (Eigen::Index j = 0; j < size; ++j) lower.col(j).head(j + 1).setConstant(NAN);
  return lower;
}

ColumnMajor completed(const ColumnMajor& lower) {
  ColumnMajor full = ColumnMajor::Identity(lower.cols(), lower.cols());
  for (Eigen::Index j = 0; j < lower.cols(); ++j)
    for (Eigen::Index i = j + 1; i < lower.cols(); ++i) full(i, j) = lower(i, j);
  return full;
}

// L times the solution is the right-hand side up to rounding.
template <class Rows>
void checkSolves(Eigen::Index size, Eigen::Index cols) {
  const ColumnMajor lower = triangle(size), full = completed(lower);
  const auto start = numbers<Rows>(size + 6, cols, 5);
  Rows y = start;
  auto part = y.middleRows(3, size);
  solveLower(lower.topRows(size), part);
  const auto tolerance = [&] {
    return 1e-14 * static_cast<double>(size) * (1 + ColumnMajor(part).cwiseAbs().maxCoeff());
  };
  EXPECT_LE((full * part - start.middleRows(3, size)).cwiseAbs().maxCoeff(), tolerance()) << size;
  y = start;
  solveLowerTransposed(lower.topRows(size), part);
  EXPECT_LE((full.transpose() * part - start.middleRows(3, size)).cwiseAbs().maxCoeff(), tolerance()) << size;
  EXPECT_EQ(y.topRows(3), start.topRows(3));
  EXPECT_EQ(y.bottomRows(3), start.bottomRows(3));
}

TEST(DenseTriangle, SolvesForOneAndForManyRightSides) {
  for (const Eigen::Index size : {1, 2, 15, 16, 17, 33, 100}) {
    checkSolves<Eigen::VectorXd>(size, 1);
    checkSolves<RowMajor>(size, 1);
    checkSolves<RowMajor>(size, 7);
    checkSolves<RowMajor>(size, 24);
  }
}

TEST(DenseTriangle, SolvesOnTheRightOfATransposedPanel) {
  const ColumnMajor lower = triangle(32), full = completed(lower);
  const auto start = numbers<ColumnMajor>(50, 32, 2);
  ColumnMajor panel = start;
  solveLower(lower.topRows(32), panel.transpose());
  EXPECT_LE((panel * full.transpose() - start).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace limber
