#include "linear/dense/dense_product.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/real_pair.h"

namespace limber {

namespace {

using Eigen::Index;

constexpr Index kTile = 4;     // rows and columns of c that are summed in registers
constexpr Index kDepth = 256;  // columns of a that are packed at once: two such panels fit the nearest cache
constexpr Index kRows = 64,
                kCols = 96;  // the block of c that is computed from one packed block of a and of b

RealPair load(const double* at) {
  RealPair pair;
  std::memcpy(&pair, at, sizeof pair);  // one load, whatever the alignment of `at`
  return pair;
}

void subtract(double* from, RealPair what) {
  const RealPair difference = load(from) - what;
  std::memcpy(from, &difference, sizeof difference);
}

// Copies `a` into panels of four rows, panel after panel, each column by column. The last panel is padded
// with zeros.
void pack(const Strided<const double>& a, std::vector<double>& to) {
  const Index panels = (a.rows + kTile - 1) / kTile;
  const auto size = static_cast<size_t>(panels * kTile * a.cols);
  if (to.size() < size) to.resize(size);
  double* out = to.data();
  for (Index first = 0; first < a.rows; first += kTile) {
    const double* in = a.data + first * a.rowStride;
    const Index count = std::min(kTile, a.rows - first);
    if (count == kTile) {
      for (Index k = 0; k < a.cols; ++k, in += a.colStride, out += kTile)
        for (Index i = 0; i < kTile; ++i) out[i] = in[i * a.rowStride];
      continue;
    }
    for (Index k = 0; k < a.cols; ++k, in += a.colStride, out += kTile)
      for (Index i = 0; i < kTile; ++i) out[i] = i < count ? in[i * a.rowStride] : 0;
  }
}

// A 4 x 4 block of a product, column by column: the upper and the lower two entries.
struct Tile {
  RealPair top[kTile], bottom[kTile];
};

Tile multiply(const double* a, const double* b, Index depth) {
  RealPair t0{}, t1{}, t2{}, t3{}, b0{}, b1{}, b2{}, b3{};
  for (Index k = 0; k < depth; ++k, a += kTile, b += kTile) {
    const RealPair top = load(a), bottom = load(a + 2);
    t0 += top * b[0];
    b0 += bottom * b[0];
    t1 += top * b[1];
    b1 += bottom * b[1];
    t2 += top * b[2];
    b2 += bottom * b[2];
    t3 += top * b[3];
    b3 += bottom * b[3];
  }
  return {{t0, t1, t2, t3}, {b0, b1, b2, b3}};
}

// `c` points to the first entry of a full tile with unit row stride.
void subtractTile(const Tile& tile, double* c, Index colStride) {
  for (Index j = 0; j < kTile; ++j, c += colStride) {
    subtract(c, tile.top[j]);
    subtract(c + 2, tile.bottom[j]);
  }
}

// The same for the part of a tile that lies within `c`.
void subtractPart(const Tile& tile, const Strided<double>& c) {
  for (Index j = 0; j < c.cols; ++j)
    for (Index i = 0; i < c.rows; ++i)
      c.data[i + j * c.colStride] -= i < 2 ? tile.top[j][i] : tile.bottom[j][i - 2];
}

// Packed blocks of both factors, `depth` columns and rows each.
struct Packed {
  const double *a, *b;
  Index depth;
};

// Tiles of which all rows are less than their column plus `least` are left out.
void subtractPacked(const Packed& packed, const Strided<double>& c, Index least) {
  const auto& [a, b, depth] = packed;
  for (Index col = 0; col < c.cols; col += kTile)
    for (Index row = std::max<Index>(0, (col + least) / kTile * kTile); row < c.rows; row += kTile) {
      const Tile tile = multiply(a + row * depth, b + col * depth, depth);
      double* to = c.data + row + col * c.colStride;
      if (row + kTile <= c.rows && col + kTile <= c.cols)
        subtractTile(tile, to, c.colStride);
      else
        subtractPart(tile,
                     {to, std::min(kTile, c.rows - row), std::min(kTile, c.cols - col), 1, c.colStride});
    }
}

// y -= a x, four columns of a at a time, where a and y have unit row stride.
void subtractColumns(const Strided<const double>& a, const double* x, Index stride, double* y) {
  Index k = 0;
  for (; k + kTile <= a.cols; k += kTile) {
    const double *c0 = a.data + k * a.colStride, *c1 = c0 + a.colStride, *c2 = c1 + a.colStride,
                 *c3 = c2 + a.colStride;
    const double x0 = x[k * stride], x1 = x[(k + 1) * stride], x2 = x[(k + 2) * stride],
                 x3 = x[(k + 3) * stride];
    Index i = 0;
    for (; i + 2 <= a.rows; i += 2)
      subtract(y + i, load(c0 + i) * x0 + load(c1 + i) * x1 + (load(c2 + i) * x2 + load(c3 + i) * x3));
    for (; i < a.rows; ++i) y[i] -= c0[i] * x0 + c1[i] * x1 + (c2[i] * x2 + c3[i] * x3);
  }
  for (; k < a.cols; ++k) {
    const double* column = a.data + k * a.colStride;
    for (Index i = 0; i < a.rows; ++i) y[i] -= column[i] * x[k * stride];
  }
}

double sum(RealPair a) {
  return a[0] + a[1];
}

// y -= a x, four rows of a at a time, where a has unit column stride and x and y are contiguous.
void subtractDots(const Strided<const double>& a, const double* x, double* y) {
  Index row = 0;
  for (; row + kTile <= a.rows; row += kTile) {
    const double *r0 = a.data + row * a.rowStride, *r1 = r0 + a.rowStride, *r2 = r1 + a.rowStride,
                 *r3 = r2 + a.rowStride;
    RealPair d0{}, d1{}, d2{}, d3{};
    Index k = 0;
    for (; k + 2 <= a.cols; k += 2) {
      const RealPair at = load(x + k);
      d0 += load(r0 + k) * at;
      d1 += load(r1 + k) * at;
      d2 += load(r2 + k) * at;
      d3 += load(r3 + k) * at;
    }
    const double last = k < a.cols ? x[k] : 0;
    const auto rest = [&](const double* r) { return k < a.cols ? r[k] * last : 0; };
    y[row] -= sum(d0) + rest(r0);
    y[row + 1] -= sum(d1) + rest(r1);
    y[row + 2] -= sum(d2) + rest(r2);
    y[row + 3] -= sum(d3) + rest(r3);
  }
  for (; row < a.rows; ++row) {
    double dot = 0;
    for (Index k = 0; k < a.cols; ++k) dot += a.data[row * a.rowStride + k] * x[k];
    y[row] -= dot;
  }
}

struct Range {
  Index first, count;
};

template <class Scalar>
Strided<Scalar> block(const Strided<Scalar>& m, Range rows, Range cols) {
  return {m.data + rows.first * m.rowStride + cols.first * m.colStride, rows.count, cols.count, m.rowStride,
          m.colStride};
}

// c -= a b where c has unit row stride. With `isLower` only the blocks that reach the diagonal or lie below.
void subtractBlocks(const Strided<const double>& a, const Strided<const double>& b, const Strided<double>& c,
                    bool isLower) {
  thread_local std::vector<double> packedA, packedB;
  for (Index k = 0; k < a.cols; k += kDepth) {
    const Index depth = std::min(kDepth, a.cols - k);
    for (Index col = 0; col < c.cols; col += kCols) {
      const Index cols = std::min(kCols, c.cols - col);
      pack(block(b, {k, depth}, {col, cols}).transpose(), packedB);
      for (Index row = isLower ? col / kRows * kRows : 0; row < c.rows; row += kRows) {
        const Index rows = std::min(kRows, c.rows - row), least = isLower ? col - row : -kCols;
        pack(block(a, {row, rows}, {k, depth}), packedA);
        subtractPacked({packedA.data(), packedB.data(), depth}, block(c, {row, rows}, {col, cols}), least);
      }
    }
  }
}

}  // namespace

void subtractStridedProduct(const Strided<const double>& a, const Strided<const double>& b,
                            const Strided<double>& c) {
  if (c.rowStride != 1) return subtractStridedProduct(b.transpose(), a.transpose(), c.transpose());
  if (c.cols == 1 && a.rowStride == 1) return subtractColumns(a, b.data, b.rowStride, c.data);
  if (c.cols == 1 && a.colStride == 1 && b.rowStride == 1) return subtractDots(a, b.data, c.data);
  subtractBlocks(a, b, c, false);
}

void subtractLowerStridedProduct(const Strided<const double>& a, const Strided<const double>& b,
                                 const Strided<double>& c) {
  subtractBlocks(a, b, c, true);
}

}  // namespace limber
