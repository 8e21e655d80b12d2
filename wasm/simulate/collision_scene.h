#pragma once

#include <optional>
#include <vector>

#include "base/vec3.h"

namespace limber {

// A capsule of `radius` around the segment from `from` to `to`; a ball where both ends are the same point.
struct Collider {
  Vec3 from, to;
  double radius;  // > 0
};

// All that a body can touch besides itself; nothing in it moves within a step. Lengths are in units of the
// mesh wherever a caller gives or gets a scene, and in metres inside a simulation.
struct CollisionScene {
  std::optional<double> ground = {};  // height of a horizontal floor along y
  std::vector<Collider> colliders = {};

  bool empty() const { return !ground && colliders.empty(); }
};

}  // namespace limber
