#include "elastic/solid/hexahedron.h"

#include <Eigen/Cholesky>
#include <numeric>

namespace limber {

namespace {

// The smallest stiffness of a bubble, relative to that in a full cell: in a sliver a bubble may have no
// strain at all.
constexpr double kBubbleFloor = 1e-12;

Vec3 pointAt(int q) {
  return {0.5 * (q % 3), 0.5 * (q / 3 % 3), 0.5 * (q / 9)};
}

// One factor of a corner's shape function, and its derivative.
double linear(int side, double x) {
  return side ? x : 1 - x;
}
double derivative(int side) {
  return side ? 1 : -1;
}

}  // namespace

std::array<double, 3> lagrangeIntegrals(double x) {
  const double square = x * x, cube = square * x;
  return {x - 1.5 * square + 2.0 / 3 * cube, 2 * square - 4.0 / 3 * cube, 2.0 / 3 * cube - 0.5 * square};
}

double filledFraction(const CellMeasure& measure) {
  return std::accumulate(measure.begin(), measure.end(), 0.0);
}

std::array<double, 8> trilinearWeights(const Vec3& point) {
  std::array<double, 8> weights;
  for (int k = 0; k < 8; ++k)
    weights[k] = linear(k & 1, point.x) * linear(k >> 1 & 1, point.y) * linear(k >> 2, point.z);
  return weights;
}

Hexahedron::Hexahedron(const Vec3& size, double poisson)
    : size_(size),
      volume_(size.x * size.y * size.z),
      lambda_(poisson / ((1 + poisson) * (1 - 2 * poisson))),
      mu_(0.5 / (1 + poisson)) {
  gradients_.setZero();
  for (int q = 0; q < 27; ++q) {
    const Vec3 p = pointAt(q);
    for (int k = 0; k < 8; ++k) {
      const int side[3] = {k & 1, k >> 1 & 1, k >> 2};
      for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        gradients_(3 * k + axis, q) =
            derivative(side[axis]) * linear(side[u], p[u]) * linear(side[v], p[v]) / size[axis];
      }
    }
    for (int axis = 0; axis < 3; ++axis) gradients_(24 + 4 * axis, q) = 2 * p[axis] / size[axis];
  }
}

Hexahedron::Matrix Hexahedron::stiffness(const CellMeasure& measure) const {
  constexpr int kSize = 3 * kFunctions;
  const Eigen::Map<const Eigen::Matrix<double, 27, 1>> weights(measure.data());
  Eigen::Matrix<double, kSize, 27> gradients = gradients_;
  const double total = weights.sum();
  for (int axis = 0; axis < 3 && total > 0; ++axis)
    gradients.row(24 + 4 * axis).array() -= gradients.row(24 + 4 * axis).dot(weights) / total;
  Eigen::Matrix<double, kSize, 27> weighted = gradients;
  for (int q = 0; q < 27; ++q) weighted.col(q) *= volume_ * weights[q];
  const Eigen::Matrix<double, kSize, kSize> products = weighted * gradients.transpose();

  Eigen::Matrix<double, kSize, kSize> k;
  for (int j = 0; j < kFunctions; ++j)
    for (int i = 0; i < kFunctions; ++i) {
      const Eigen::Matrix3d g = products.block<3, 3>(3 * i, 3 * j);
      k.block<3, 3>(3 * i, 3 * j) = lambda_ * g + mu_ * g.transpose();
      k.block<3, 3>(3 * i, 3 * j).diagonal().array() += mu_ * g.trace();
    }
  for (int axis = 0; axis < 3; ++axis)
    k.diagonal().segment<3>(24 + 3 * axis).array() += kBubbleFloor * volume_ / (size_[axis] * size_[axis]);
  const Eigen::LDLT<Eigen::Matrix<double, 9, 9>> bubbles(k.bottomRightCorner<9, 9>());
  const Eigen::Matrix<double, 9, 24> coupling = k.bottomLeftCorner<9, 24>();
  return k.topLeftCorner<24, 24>() - coupling.transpose() * bubbles.solve(coupling);
}

std::array<double, 8> Hexahedron::mass(const CellMeasure& measure) const {
  std::array<double, 8> mass = {};
  for (int q = 0; q < 27; ++q) {
    const auto shape = trilinearWeights(pointAt(q));
    for (int k = 0; k < 8; ++k) mass[k] += volume_ * measure[q] * shape[k];
  }
  for (double& m : mass) m = std::max(m, 0.0);  // rounding may make it negative
  return mass;
}

}  // namespace limber
