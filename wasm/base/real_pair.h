#pragma once

#ifdef __wasm_simd128__
#include <wasm_simd128.h>
#endif

#include "base/vec3.h"

namespace limber {

// Two numbers in one SIMD register (SSE2, wasm simd128). The operators are built into GCC and Clang. Every
// operation rounds each lane as it would round a double, so the same formula gives the same bits for both.
using RealPair = double __attribute__((vector_size(16)));

// The nearest float32, as double.
inline double asFloat(double x) {
  float nearest = static_cast<float>(x);
#if defined(__GNUC__) && !defined(__clang__)
  // GCC 12 drops the rounding when it vectorises these statements itself.
  asm("" : "+m"(nearest));
#endif
  return nearest;
}
inline RealPair asFloat(RealPair x) {
#ifdef __wasm_simd128__
  // Without the intrinsics Clang converts each lane separately.
  return RealPair(wasm_f64x2_promote_low_f32x4(wasm_f32x4_demote_f64x2_zero(v128_t(x))));
#else
  using FloatPair = float __attribute__((vector_size(8)));
  return __builtin_convertvector(__builtin_convertvector(x, FloatPair), RealPair);
#endif
}

// A point whose coordinates are doubles or pairs of doubles.
template <class Real>
struct Point {
  Real x, y, z;
};

template <class Real>
Point<Real> operator+(const Point<Real>& a, const Point<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class Real>
Point<Real> operator-(const Point<Real>& a, const Point<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Real, class Factor>
Point<Real> operator*(const Point<Real>& a, Factor s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class Real>
Real dot(const Point<Real>& a, const Point<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
Point<Real> cross(const Point<Real>& a, const Point<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Point<double> asPoint(const Vec3& p) {
  return {p.x, p.y, p.z};
}
inline Vec3 asVec3(const Point<double>& p) {
  return {p.x, p.y, p.z};
}
inline Point<RealPair> asPair(const Vec3& p, const Vec3& q) {
  return {RealPair{p.x, q.x}, RealPair{p.y, q.y}, RealPair{p.z, q.z}};
}
// Point i of the pair.
inline Vec3 lane(const Point<RealPair>& p, int i) {
  return {p.x[i], p.y[i], p.z[i]};
}

}  // namespace limber
