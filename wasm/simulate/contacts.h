#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulate/particles.h"
#include "simulate/simulation.h"

namespace limber {

// What a body can touch, in metres.
struct Obstacles {
  std::optional<double> ground;  // height of a floor across y
  std::vector<Collider> colliders = {};
  double friction = 0;
};

// Vertices that may touch something within the running step. A vertex inside is put onto the surface (so its
// velocity into it is gone: contacts do not bounce), and loses up to `friction` times the depth of its
// sliding in the substep (Coulomb, as Mueller et al. 2007).
class Contacts {
 public:
  // Those of `reach` metres from an obstacle, or less, and those that may come there at twice their speed.
  void rebase(const Particles& particles, const Obstacles& obstacles, double reach, int substeps);
  void project(Particles& particles) const;
  size_t count() const { return contacts_.size(); }

 private:
  struct Contact {
    uint32_t vertex;
    bool flat;    // the ground: the obstacle lies where y is below 0
    Float4 base;  // of the vertex, from the start of the axis (or the floor), at the start of the step
    Float4 axis;  // of a capsule; 0 of a ball
    float inverseSquare;  // 1 / |axis|^2, 0 of a ball
    float radius;
  };
  std::vector<Contact> contacts_;
  float friction_ = 0;
};

}  // namespace limber
