#pragma once

#include <cstdint>
#include <vector>

#include "simulate/blocks.h"
#include "simulate/collision_scene.h"
#include "simulate/contacts/point_contact.h"
#include "simulate/particles.h"

namespace limber {

// Contacts of vertices with the ground and colliders. A vertex that is inside is moved onto the surface,
// which removes its velocity into the surface (contacts do not bounce), and its sliding in the substep is
// reduced by up to `friction` times the depth (Coulomb friction as in Mueller et al. 2007).
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
    PointContact point;
  };
  const Blocks& blocks_;
  std::vector<std::vector<Contact>> contacts_;  // by block
};

}  // namespace limber
