#pragma once

#include <algorithm>
#include <cmath>

#include "simulate/collision_scene.h"
#include "simulate/particles.h"

namespace limber {

inline float dot3(Float4 a, Float4 b) {
  const Float4 product = a * b;
  return product[0] + product[1] + product[2];
}

// A collider in float; points are relative to the start of its axis.
struct ContactSurface {
  Float4 axis;          // of a capsule; 0 for a ball
  float inverseSquare;  // 1 / |axis|^2; 0 for a ball
  float radius;

  Float4 nearestOnAxis(Float4 point) const {
    return splat(std::clamp(dot3(point, axis) * inverseSquare, 0.0f, 1.0f)) * axis;
  }
};

inline ContactSurface surfaceOf(const Collider& collider) {
  const Vec3 axis = collider.to - collider.from;
  const double squared = squaredLength(axis);
  return {toFloat4(axis), squared > 0 ? static_cast<float>(1 / squared) : 0.0f,
          static_cast<float>(collider.radius)};
}

inline double distanceToAxis(const Vec3& point, const Collider& collider) {
  const Vec3 axis = collider.to - collider.from, offset = point - collider.from;
  const double squared = squaredLength(axis);
  const double along = squared > 0 ? std::clamp(dot(offset, axis) / squared, 0.0, 1.0) : 0;
  return length(offset - axis * along);
}

// The tangential part of a motion q that friction removes, at most `most` metres (Coulomb friction as in
// Mueller et al. 2007).
inline Float4 frictionOf(Float4 q, Float4 normal, float most) {
  const Float4 sliding = q - splat(dot3(q, normal)) * normal;
  const float slid = std::sqrt(dot3(sliding, sliding));
  return slid > 0 ? splat(std::min(1.0f, most / slid)) * sliding : Float4{};
}

// The effect of a contact on a point that is inside a surface: it adds `out` to the motion of the substep,
// which moves the point onto the surface, and then subtracts `friction`. Metres.
struct ContactPush {
  Float4 out, friction;
};

// For a point that moves by q in the substep and is `depth` metres inside, behind a unit `normal`. Friction
// takes at most its coefficient times the depth.
inline ContactPush pushOf(Float4 q, Float4 normal, float depth, float coefficient) {
  const Float4 out = splat(depth) * normal;
  return {out, frictionOf(q + out, normal, coefficient * depth)};
}

}  // namespace limber
