#pragma once

#include "base/vec3.h"

namespace limber {

// The weighted sum of squared distances to planes, as a function of the point p (Garland & Heckbert 1997):
// p^T A p + 2 b.p + c, A symmetric. `area` is what the sum is normalised by.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // A
  Vec3 b;
  double c = 0;
  double area = 0;

  Quadric& operator+=(const Quadric& q) {
    xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
    b += q.b;
    c += q.c;
    area += q.area;
    return *this;
  }
};

inline Quadric operator+(Quadric p, const Quadric& q) {
  return p += q;
}

// Adds `weight` times the squared distance to the plane through `point` with the unit normal n.
inline void addPlane(Quadric& q, const Vec3& n, const Vec3& point, double weight) {
  const Vec3 w = n * weight;
  const double offset = -dot(n, point);
  q.xx += w.x * n.x, q.xy += w.x * n.y, q.xz += w.x * n.z;
  q.yy += w.y * n.y, q.yz += w.y * n.z, q.zz += w.z * n.z;
  q.b += w * offset;
  q.c += weight * offset * offset;
}

// A p + b: half of the gradient.
inline Vec3 halfGradient(const Quadric& q, const Vec3& p) {
  return {q.xx * p.x + q.xy * p.y + q.xz * p.z + q.b.x, q.xy * p.x + q.yy * p.y + q.yz * p.z + q.b.y,
          q.xz * p.x + q.yz * p.y + q.zz * p.z + q.b.z};
}

// The weighted sum at p over the accumulated area: a mean squared distance where all weights are areas
// (Garland 1999, normalised quadrics). Never negative; 0 without area.
inline double normalizedError(const Quadric& q, const Vec3& p) {
  const double sum = dot(p, halfGradient(q, p) + q.b) + q.c;
  return sum > 0 && q.area > 0 ? sum / q.area : 0;
}

// The point of least error; where the planes leave it open (on flat faces and along straight creases), the
// one nearest to `start`. Solved as a proximal-point iteration: each of three steps minimises the error plus
// `kDamping` tr(A) times the squared way from the last point. The damping keeps the solve safe; repeating it
// takes its bias back, to kDamping^3 in well-determined directions.
inline Vec3 minimize(const Quadric& q, const Vec3& start) {
  constexpr double kDamping = 1e-5;
  const double damping = kDamping * (q.xx + q.yy + q.zz);
  if (!(damping > 0)) return start;
  // L D L^T of the damped matrix; its pivots are positive.
  const double d0 = q.xx + damping, l10 = q.xy / d0, l20 = q.xz / d0;
  const double d1 = q.yy + damping - l10 * q.xy, u21 = q.yz - l20 * q.xy, l21 = u21 / d1;
  const double d2 = q.zz + damping - l20 * q.xz - l21 * u21;
  const double inverse0 = 1 / d0, inverse1 = 1 / d1, inverse2 = 1 / d2;
  Vec3 p = start;
  for (int step = 0; step < 3; ++step) {
    const Vec3 g = halfGradient(q, p);
    const double y1 = g.y - l10 * g.x, y2 = g.z - l20 * g.x - l21 * y1;
    const double z = y2 * inverse2, y = y1 * inverse1 - l21 * z, x = g.x * inverse0 - l10 * y - l20 * z;
    p -= {x, y, z};
  }
  return p;
}

}  // namespace limber
