#pragma once

#include <cmath>
#include <optional>

#include "simulate/collision_scene.h"
#include "simulate/contacts/contact_surface.h"
#include "simulate/particles.h"
#include "simulate/simulation_options.h"

namespace limber {

// The distance around a vertex or triangle within which contacts are searched: `margin` metres, plus its
// motion in a step at twice its speed at the start of the step.
struct ContactDistance {
  double margin;
  int substeps;

  // For a vertex that moves by q in a substep, from |q|^2.
  double of(double squaredMotion) const { return margin + 2 * substeps * std::sqrt(squaredMotion); }
};

// The margin as a fraction of the diagonal of the body at rest.
inline constexpr double kContactMargin = 0.02;

// The margin includes the fall of a body from rest in a step, which can exceed the size of a small body.
inline ContactDistance contactDistance(double restDiagonal, const Vec3& gravity, int substeps) {
  return {kContactMargin * restDiagonal + length(gravity) * kStepSeconds * kStepSeconds, substeps};
}

// A point that may touch the ground or a collider within a step.
struct PointContact {
  bool flat;    // the contact is with the ground, which fills y < 0
  Float4 base;  // the point relative to the start of the axis, or to the ground, at the start of the step
  ContactSurface surface;

  // The effect on the point with this motion in a substep; nothing if it is outside. `friction` is the
  // coefficient.
  std::optional<ContactPush> pushAt(const Motion& motion, float friction) const {
    Float4 normal = {0, 1, 0, 0};
    const Float4 point = base + (motion.u + motion.q);
    float depth = -point[1];
    if (!flat) {
      const Float4 outwards = point - surface.nearestOnAxis(point);
      const float distance = std::sqrt(dot3(outwards, outwards));
      depth = surface.radius - distance;
      if (distance > 0) normal = outwards / splat(distance);
    }
    if (!(depth > 0)) return std::nullopt;
    return pushOf(motion.q, normal, depth, friction);
  }
};

// Calls add(PointContact) for the ground and each collider of a scene within `near` metres of a point. The
// scene is in metres, as the point is.
template <class Add>
void forEachContactNear(const Vec3& point, double near, const CollisionScene& scene, Add add) {
  if (scene.ground && point.y - *scene.ground < near)
    add(PointContact{true, toFloat4({0, point.y - *scene.ground, 0}), ContactSurface{}});
  for (const Collider& collider : scene.colliders) {
    if (distanceToAxis(point, collider) > collider.radius + near) continue;
    add(PointContact{false, toFloat4(point - collider.from), surfaceOf(collider)});
  }
}

}  // namespace limber
