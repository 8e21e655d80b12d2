#pragma once

#include <cmath>
#include <cstdint>

#if defined(__wasm_simd128__)
#include <wasm_simd128.h>
#elif defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace limber {

// Four floats at once. With the vector extension of the compilers the same source compiles to wasm SIMD and
// to native code.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 splat(float a) {
  return Float4{a, a, a, a};
}
template <int lane>
Float4 splatLane(Float4 a) {
  return __builtin_shufflevector(a, a, lane, lane, lane, lane);
}

// The square root is correctly rounded, so that every machine gives the same bits.
inline Float4 squareRoot(Float4 a) {
#if defined(__wasm_simd128__)
  return reinterpret_cast<Float4>(wasm_f32x4_sqrt(reinterpret_cast<v128_t>(a)));
#elif defined(__SSE__)
  return reinterpret_cast<Float4>(_mm_sqrt_ps(reinterpret_cast<__m128>(a)));
#else
  return Float4{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}
inline Float4 larger(Float4 a, Float4 b) {
  return a > b ? a : b;
}

// Lane k of the result is the sum over the lanes of the k-th argument.
inline Float4 laneSums(Float4 a, Float4 b, Float4 c, Float4 d) {
  const Float4 ab = __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Float4 cd = __builtin_shufflevector(c, d, 0, 4, 1, 5) + __builtin_shufflevector(c, d, 2, 6, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

// Four vectors, one per lane.
struct Vec3x4 {
  Float4 x, y, z;
};

inline Vec3x4 operator+(const Vec3x4& a, const Vec3x4& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3x4 operator-(const Vec3x4& a, const Vec3x4& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3x4 operator*(const Vec3x4& a, Float4 s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Float4 dot(const Vec3x4& a, const Vec3x4& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3x4 cross(const Vec3x4& a, const Vec3x4& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// From four vectors (x, y, z, anything) to one vector per lane.
inline Vec3x4 toLanes(const Float4 (&v)[4]) {
  const Float4 xy01 = __builtin_shufflevector(v[0], v[1], 0, 4, 1, 5);
  const Float4 xy23 = __builtin_shufflevector(v[2], v[3], 0, 4, 1, 5);
  const Float4 z01 = __builtin_shufflevector(v[0], v[1], 2, 6, 3, 7);
  const Float4 z23 = __builtin_shufflevector(v[2], v[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(xy01, xy23, 0, 1, 4, 5), __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7),
          __builtin_shufflevector(z01, z23, 0, 1, 4, 5)};
}

// From one vector per lane to four vectors (x, y, z, 0).
inline void fromLanes(const Vec3x4& a, Float4 (&v)[4]) {
  const Float4 zero{};
  const Float4 xy01 = __builtin_shufflevector(a.x, a.y, 0, 4, 1, 5);
  const Float4 xy23 = __builtin_shufflevector(a.x, a.y, 2, 6, 3, 7);
  const Float4 z01 = __builtin_shufflevector(a.z, zero, 0, 4, 1, 5);
  const Float4 z23 = __builtin_shufflevector(a.z, zero, 2, 6, 3, 7);
  v[0] = __builtin_shufflevector(xy01, z01, 0, 1, 4, 5);
  v[1] = __builtin_shufflevector(xy01, z01, 2, 3, 6, 7);
  v[2] = __builtin_shufflevector(xy23, z23, 0, 1, 4, 5);
  v[3] = __builtin_shufflevector(xy23, z23, 2, 3, 6, 7);
}

// Solves the symmetric positive definite system (xx xy xz; xy yy yz; xz yz zz) s = r by L D L^T in every
// lane. Pivots are at least 1e-5 of their diagonal entry, so that rounding cannot make them 0.
struct Symmetric3x4 {
  Float4 xx, xy, xz, yy, yz, zz;
};
inline Vec3x4 solve(const Symmetric3x4& a, const Vec3x4& r) {
  const Float4 one = splat(1);
  const Float4 inverseX = one / a.xx;
  const Float4 ly = a.xy * inverseX, lz = a.xz * inverseX;
  const Float4 least = splat(1e-5f), dy = larger(a.yy - ly * a.xy, least * a.yy), yz = a.yz - ly * a.xz;
  const Float4 inverseY = one / dy;
  const Float4 mz = yz * inverseY;
  const Float4 dz = larger(a.zz - lz * a.xz - mz * yz, least * a.zz);
  const Float4 sy = r.y - ly * r.x, sz = (r.z - lz * r.x - mz * sy) / dz;
  const Float4 y = sy * inverseY - mz * sz;
  return {r.x * inverseX - ly * y - lz * sz, y, sz};
}

}  // namespace limber
