#pragma once

#include "base/real_pair.h"
#include "base/vec3.h"

namespace limber {

// The weighted sum of squared distances to planes, as a function of the point p (Garland & Heckbert 1997):
// p^T A p + 2 b.p + c, A symmetric. The sum is normalised by `area`. QuadricOf<RealPair> is a pair of
// quadrics.
template <class Real>
struct QuadricOf {
  Real xx, xy, xz, yy, yz, zz;  // A
  Point<Real> b;
  Real c, area;
};

using Quadric = QuadricOf<double>;

template <class Real>
QuadricOf<Real> operator+(const QuadricOf<Real>& p, const QuadricOf<Real>& q) {
  return {p.xx + q.xx, p.xy + q.xy, p.xz + q.xz, p.yy + q.yy,    p.yz + q.yz,
          p.zz + q.zz, p.b + q.b,   p.c + q.c,   p.area + q.area};
}

inline QuadricOf<RealPair> asPair(const Quadric& p, const Quadric& q) {
  return {RealPair{p.xx, q.xx},
          RealPair{p.xy, q.xy},
          RealPair{p.xz, q.xz},
          RealPair{p.yy, q.yy},
          RealPair{p.yz, q.yz},
          RealPair{p.zz, q.zz},
          asPair(asVec3(p.b), asVec3(q.b)),
          RealPair{p.c, q.c},
          RealPair{p.area, q.area}};
}

// `weight` times the squared distance to the plane through `point` with the unit normal n; adds no area.
inline Quadric planeQuadric(const Vec3& n, const Vec3& point, double weight) {
  const Vec3 w = n * weight;
  const double offset = -dot(n, point);
  return {w.x * n.x, w.x * n.y, w.x * n.z,           w.y * n.y,
          w.y * n.z, w.z * n.z, asPoint(w * offset), weight * offset * offset,
          0};
}

// A p + b: half of the gradient.
template <class Real>
Point<Real> halfGradient(const QuadricOf<Real>& q, const Point<Real>& p) {
  return {q.xx * p.x + q.xy * p.y + q.xz * p.z + q.b.x, q.xy * p.x + q.yy * p.y + q.yz * p.z + q.b.y,
          q.xz * p.x + q.yz * p.y + q.zz * p.z + q.b.z};
}

// The weighted sum at p over the area, which is a mean squared distance if all weights are areas (Garland
// 1999, normalised quadrics). Never negative; 0 without area.
template <class Real>
Real normalizedError(const QuadricOf<Real>& q, const Point<Real>& p) {
  const Real sum = dot(p, halfGradient(q, p) + q.b) + q.c;
  const Real mean = sum / q.area;
  return ((mean > 0) & (q.area > 0)) ? mean : Real{};
}

// The point of least error; if the planes do not determine it (on flat faces and along straight creases), the
// one of these points that is nearest to `start`. Solved as a proximal-point iteration: each of two steps
// minimises the error plus kDamping tr(A) times the squared distance from the last point. The damping keeps
// the solve stable; the second step reduces its bias to kDamping^2 in well-determined directions, which is
// below the resolution of float32 positions.
template <class Real>
Point<Real> minimize(const QuadricOf<Real>& q, const Point<Real>& start) {
  constexpr double kDamping = 1e-5;
  const Real damping = kDamping * (q.xx + q.yy + q.zz);
  // The damped matrix and its cofactors; it is positive definite unless it is 0.
  const Real xx = q.xx + damping, yy = q.yy + damping, zz = q.zz + damping;
  const Real cxx = yy * zz - q.yz * q.yz, cxy = q.xz * q.yz - q.xy * zz, cxz = q.xy * q.yz - q.xz * yy;
  const Real cyy = xx * zz - q.xz * q.xz, cyz = q.xy * q.xz - q.yz * xx, czz = xx * yy - q.xy * q.xy;
  const Real determinant = xx * cxx + q.xy * cxy + q.xz * cxz;
  const Real inverse = determinant > 0 ? 1 / determinant : Real{};
  const auto solve = [&](const Point<Real>& g) {
    return Point<Real>{cxx * g.x + cxy * g.y + cxz * g.z, cxy * g.x + cyy * g.y + cyz * g.z,
                       cxz * g.x + cyz * g.y + czz * g.z};
  };
  // The gradient after the first step is the damping times its displacement.
  const Point<Real> first = solve(halfGradient(q, start) * inverse);
  return start - (first + solve(first * (damping * inverse)));
}

}  // namespace limber
