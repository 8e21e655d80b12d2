#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/vec3.h"

namespace limber {

// The error of displacements u_f(p) that are linear over each triangle, in a metric M_f for each triangle:
// with c(p) the area-weighted mean of the u_f(p),
//   E(p) = sum_f a_f (u_f(p) - c(p))^T M_f (u_f(p) - c(p)).
// That is a quadratic form in (p, 1). It follows from sums over the triangles: the form a u^T M u and the
// matrix a M, which all displacements share, and for each of them the fields a u and a M u. All are flat
// arrays that can be added.

// A field at p is the dot product of its four numbers with (p, 1).
using LinearField = std::array<double, 4>;
// xx, xy, xz, yy, yz, zz of a symmetric matrix.
using Metric = std::array<double, 6>;

// The matrix of a form: xx, xy, xz, yy, yz, zz; half of its linear part: x, y, z; its constant.
constexpr uint32_t kFormSize = 10;

// The number of sums for `count` displacements: first the matrix a M; then of each displacement k
// [6 + 24 * k + 4 * c + i] of a u and [6 + 24 * k + 12 + 4 * c + i] of a M u, c the coordinate.
constexpr uint32_t displacementSums(uint32_t count) {
  return count == 0 ? 0 : 6 + 24 * count;
}

// The metric of a triangle and its area.
struct WeightedMetric {
  Metric metric;
  double area;
};

// The metric in which the component along the unit normal counts fully, and the tangential component with the
// factor `within`.
Metric metricAlong(const Vec3& normal, double within);

// Adds `weight` times the square of the field.
void addSquare(double* form, const LinearField& field, double weight);

// Adds the displacements of a triangle, three fields for each, to the sums and to the form.
void addDisplacements(double* sums, double* form, std::span<const LinearField> u,
                      const WeightedMetric& triangle);

// Adds to the form the terms of E other than the sum of a u^T M u, for two sets of triangles with these total
// sums; `area` is their total area.
void takeMeansOff(double* form, const std::array<const double*, 2>& sums, uint32_t count, double area);

}  // namespace limber
