#include "linear/block_lanczos.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "linear/dense/tall_product.h"
#include "linear/eigen_search.h"

namespace limber {
namespace {

// A remaining direction of a block is dropped if its squared length is below this fraction of the longest: it
// is the rounding error of vectors that depend linearly on the others.
constexpr double kDependent = 1e-14;
constexpr double kWellConditioned = 1e-6;  // above this fraction, one pass leaves a basis orthonormal to 1e-9

// An orthonormal basis of the columns of a block. A second pass removes the rounding errors of the first.
Eigen::MatrixXd orthonormalised(Eigen::MatrixXd block) {
  for (int pass = 0; pass < 2 && block.cols() > 0; ++pass) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> squares(transposedProduct(block, block));
    const Eigen::VectorXd& lengths = squares.eigenvalues();
    const Eigen::Index size = lengths.size(),
                       dropped = lengths[size - 1] > 0
                                     ? (lengths.array() <= kDependent * lengths[size - 1]).count()
                                     : size;
    const Eigen::VectorXd scale = lengths.tail(size - dropped).cwiseSqrt().cwiseInverse();
    block = tallProduct(block, squares.eigenvectors().rightCols(size - dropped) * scale.asDiagonal());
    if (dropped == 0 && lengths[0] > kWellConditioned * lengths[size - 1]) break;
  }
  return block;
}

class Run {
 public:
  Run(const ShiftedPencil& pencil, const BlockLanczosOptions& options)
      : pencil_(pencil),
        options_(options),
        basis_(pencil.heavyCount(), options.mostVectors),
        projected_(Eigen::MatrixXd::Zero(options.mostVectors, options.mostVectors)) {}

  BlockLanczosPairs from(const Eigen::MatrixXd& start) {
    Eigen::MatrixXd block = orthonormalised(start);
    for (int blocks = 1; block.cols() > 0 && size_ + block.cols() <= options_.mostVectors; ++blocks) {
      Eigen::MatrixXd rest = expand(block);
      findPairs(rest, block.cols());
      if (blocks >= options_.leastBlocks && hasConverged()) break;
      block = orthonormalised(std::move(rest));
    }
    return pairs();
  }

 private:
  // Adds a block to the basis; returns the part of its image that is orthogonal to the basis. One pass is
  // enough: it leaves rounding errors of the image, and directions of the rest that are not far longer than
  // these are dropped.
  Eigen::MatrixXd expand(const Eigen::MatrixXd& block) {
    const Eigen::Index first = size_;
    basis_.middleCols(first, block.cols()) = block;
    size_ += block.cols();
    Eigen::MatrixXd image = pencil_.invert(block);
    const Eigen::MatrixXd shares = transposedProduct(basis_.leftCols(size_), image);
    subtractTallProduct(basis_.leftCols(size_), shares, image);
    projected_.block(0, first, size_, block.cols()) = shares;
    return image;
  }

  // Ritz pairs, those with the largest eigenvalue of the inverse first, and the residual of each: `rest`
  // times its part in the last block.
  void findPairs(const Eigen::MatrixXd& rest, Eigen::Index lastCount) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        projected_.topLeftCorner(size_, size_).selfadjointView<Eigen::Upper>());
    inverse_ = ritz.eigenvalues().reverse();
    shares_ = ritz.eigenvectors().rowwise().reverse();
    const Eigen::MatrixXd last = shares_.bottomRows(lastCount);
    const Eigen::MatrixXd squares = transposedProduct(rest, rest);
    residual_ = last.cwiseProduct(squares * last).colwise().sum().transpose().cwiseMax(0).cwiseSqrt();
    residual_.array() /= inverse_.array().abs();
  }

  // The square of the inverse residual is the relative error of lambda - shift; relative to lambda it is
  // larger by the quotient of both. A zero eigenvalue has no relative error.
  bool hasConverged() const {
    if (residual_.size() < options_.pairs) return false;
    for (Eigen::Index k = 0; k < options_.exact; ++k) {
      const double share = std::min(1.0, 1 + pencil_.shift() * inverse_[k]);  // lambda / (lambda - shift)
      const double factor = share > kZeroRatio ? std::sqrt(share) : 1;
      if (!(residual_[k] <= factor * options_.tolerance)) return false;
    }
    return true;
  }

  BlockLanczosPairs pairs() const {
    const Eigen::Index count = std::min(options_.pairs, inverse_.size());
    return {{inverse_.head(count).cwiseInverse().array() + pencil_.shift(),
             tallProduct(basis_.leftCols(size_), shares_.leftCols(count))},
            residual_.head(count),
            hasConverged()};
  }

  const ShiftedPencil& pencil_;
  const BlockLanczosOptions& options_;
  Eigen::MatrixXd basis_;
  Eigen::Index size_ = 0;
  Eigen::MatrixXd projected_;  // of the inverted pencil onto the basis: the upper half
  Eigen::VectorXd inverse_, residual_;
  Eigen::MatrixXd shares_;
};

}  // namespace

Eigen::MatrixXd randomColumns(Eigen::Index size, Eigen::Index columns) {
  Eigen::MatrixXd x(size, columns);
  uint64_t state = 0x9e3779b97f4a7c15ull;
  for (double& value : x.reshaped()) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    value = static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
  }
  return x;
}

BlockLanczosPairs blockLanczos(const ShiftedPencil& pencil, const Eigen::MatrixXd& start,
                               const BlockLanczosOptions& options) {
  return Run(pencil, options).from(start);
}

}  // namespace limber
