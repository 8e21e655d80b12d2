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
// one nearest to `start`. Solved as a proximal-point iteration: each of two steps minimises the error plus
// `kDamping` tr(A) times the squared way from the last point. The damping keeps the solve safe; repeating it
// takes its bias back, to kDamping^2 in well-determined directions, less than float32 positions show.
inline Vec3 minimize(const Quadric& q, const Vec3& start) {
  constexpr double kDamping = 1e-5;
  const double damping = kDamping * (q.xx + q.yy + q.zz);
  // The damped matrix and its cofactors; it is positive definite.
  const double xx = q.xx + damping, yy = q.yy + damping, zz = q.zz + damping;
  const double cxx = yy * zz - q.yz * q.yz, cxy = q.xz * q.yz - q.xy * zz, cxz = q.xy * q.yz - q.xz * yy;
  const double cyy = xx * zz - q.xz * q.xz, cyz = q.xy * q.xz - q.yz * xx, czz = xx * yy - q.xy * q.xy;
  const double determinant = xx * cxx + q.xy * cxy + q.xz * cxz;
  if (!(determinant > 0)) return start;
  const double scale = 1 / determinant;
  Vec3 p = start;
  for (int step = 0; step < 2; ++step) {
    const Vec3 g = halfGradient(q, p) * scale;
    p -= {cxx * g.x + cxy * g.y + cxz * g.z, cxy * g.x + cyy * g.y + cyz * g.z,
          cxz * g.x + cyz * g.y + czz * g.z};
  }
  return p;
}

}  // namespace limber
