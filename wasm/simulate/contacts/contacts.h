#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "simulate/blocks.h"
#include "simulate/collision_scene.h"
#include "simulate/contacts/contact_surface.h"
#include "simulate/particles.h"

namespace limber {

// How far around a vertex or triangle contacts are searched: `margin` metres, plus what it moves in a step at
// twice its speed.
struct ContactDistance {
  double margin;
  int substeps;

  // For a vertex that moves by q in a substep, from |q|^2.
  double of(double squaredMotion) const { return margin + 2 * substeps * std::sqrt(squaredMotion); }
};

// Contacts of vertices with the ground and colliders. A vertex that is inside is moved onto the surface,
// which takes away its velocity into it (contacts do not bounce), and loses up to `friction` times the depth
// of its sliding in the substep (Coulomb friction as in Mueller et al. 2007).
class Contacts {
 public:
  explicit Contacts(const Blocks& blocks) : blocks_(blocks), contacts_(blocks.count()) {}

  // Finds the vertices of a block that may touch something within the step. The scene is in metres.
  void rebase(const Particles& particles, const CollisionScene& scene, const ContactDistance& distance,
              size_t block);
  // One pass over the contacts of a block.
  void project(Particles& particles, float friction, size_t block) const;

 private:
  struct Contact {
    uint32_t vertex;
    bool flat;    // the contact is with the ground, which fills y < 0
    Float4 base;  // the vertex relative to the start of the axis, or to the floor, at the start of the step
    ContactSurface surface;
  };
  const Blocks& blocks_;
  std::vector<std::vector<Contact>> contacts_;  // by block
};

}  // namespace limber
