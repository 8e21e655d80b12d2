#pragma once

#include <Eigen/Core>
#include <array>

#include "base/vec3.h"

namespace limber {

// The moments of the filled part of a box-shaped cell that a trilinear element depends on: entry [x + 3 y + 9
// z] is the integral over the filled part of the product of quadratic Lagrange polynomials of the nodes x /
// 2, y / 2, z / 2, in units of the cell. As quadrature weights at these 27 points the integrals are exact
// over the filled part, whatever its shape, for all polynomials up to degree 2 in each coordinate.
using CellMeasure = std::array<double, 27>;

// The integrals from 0 to x of the three Lagrange polynomials of the nodes 0, 1/2 and 1.
std::array<double, 3> lagrangeIntegrals(double x);

// The filled fraction of the cell, in [0, 1] up to rounding.
double filledFraction(const CellMeasure& measure);

// The trilinear weights of the eight corners at a point of the unit cell. Corner k lies at
// (k & 1, k >> 1 & 1, k >> 2).
std::array<double, 8> trilinearWeights(const Vec3& point);

// The eight-node brick with Wilson's incompatible modes against shear locking: three quadratic bubbles for
// each displacement, condensed out. The mean of their strains over the filled part is subtracted (Taylor,
// Beresford and Wilson 1976), so constant strains are exact for any filling of the cell. Linear isotropic
// elasticity with E = rho = 1.
class Hexahedron {
 public:
  using Matrix = Eigen::Matrix<double, 24, 24>;

  // `size`: the side lengths of the cell.
  Hexahedron(const Vec3& size, double poisson);

  // The stiffness matrix over the displacements 3 * corner + axis. Symmetric, and positive semidefinite for
  // the measure of any actual filling.
  Matrix stiffness(const CellMeasure& measure) const;

  // The integrals of the corners' shape functions over the filled part. They are nonnegative; their sum is
  // its volume.
  std::array<double, 8> mass(const CellMeasure& measure) const;

 private:
  static constexpr int kFunctions = 11;                  // eight corners, then the bubbles along x, y and z
  Eigen::Matrix<double, 3 * kFunctions, 27> gradients_;  // (3 * function + axis, point)
  Vec3 size_;
  double volume_, lambda_, mu_;
};

}  // namespace limber
