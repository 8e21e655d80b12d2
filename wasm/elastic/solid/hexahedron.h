#pragma once

#include <Eigen/Core>
#include <array>

#include "base/vec3.h"

namespace limber {

// How the filled part of a box-shaped cell is spread, as far as a trilinear element can tell: the integral
// over the filled part of each product of quadratic Lagrange polynomials at 0, 1/2 and 1 along each axis, in
// units of the cell ([x + 3 y + 9 z]). Used as weights of a quadrature at these 27 points they integrate all
// polynomials up to degree 2 in each coordinate exactly over the filled part, whatever its shape.
using CellMeasure = std::array<double, 27>;

// Integrals of the three Lagrange polynomials from 0 to x.
std::array<double, 3> lagrangeIntegrals(double x);

// The share of the cell that is filled.
double filledFraction(const CellMeasure& measure);

// The trilinear weights of the eight corners at a point of the unit cell; corner k lies at (k & 1, k >> 1 &
// 1, k >> 2).
std::array<double, 8> trilinearWeights(const Vec3& point);

// The eight-node brick with Wilson's incompatible modes (three quadratics for each displacement), condensed
// out, against shear locking. Their strains are taken less their mean over the filled part (Taylor, Beresford
// and Wilson 1976), so that constant strains come out exactly however the cell is filled. Linear elasticity,
// isotropic, E = 1, rho = 1.
class Hexahedron {
 public:
  using Matrix = Eigen::Matrix<double, 24, 24>;

  // `size`: lengths of the cell's sides.
  Hexahedron(const Vec3& size, double poisson);

  // Over the displacements 3 * corner + axis. Symmetric and positive semidefinite for every measure of a real
  // filling.
  Matrix stiffness(const CellMeasure& measure) const;

  // Integrals of the shape functions over the filled part: none is negative, and the sum is its volume.
  std::array<double, 8> mass(const CellMeasure& measure) const;

 private:
  static constexpr int kFunctions = 11;                  // eight corners, then the bubbles along x, y, z
  Eigen::Matrix<double, 3 * kFunctions, 27> gradients_;  // [3 * function + axis], at each point
  Vec3 size_;
  double volume_, lambda_, mu_;
};

}  // namespace limber
