#pragma once

#include <optional>
#include <vector>

#include "base/vec3.h"

namespace limber {

// A capsule of `radius` around the segment from `from` to `to`; a ball if both ends coincide.
struct Collider {
  Vec3 from, to;
  double radius;  // > 0
};

// Everything that a body can touch except itself; nothing in it moves within a step. Lengths are in units of
// the mesh where callers pass or receive a scene, and in metres inside a simulation.
struct CollisionScene {
  std::optional<double> ground = {};  // height of a horizontal floor along y
  std::vector<Collider> colliders = {};

  bool empty() const { return !ground && colliders.empty(); }
};

}  // namespace limber
