#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulate/blocks.h"
#include "simulate/contacts/contact_surface.h"
#include "simulate/particles.h"
#include "simulate/simulation.h"

namespace limber {

// What a body can touch, in metres.
struct Obstacles {
  std::optional<double> ground;  // height of a floor across y
  std::vector<Collider> colliders = {};
  double friction = 0;
  bool empty() const { return !ground && colliders.empty(); }
};

// Within which distance contacts are looked for: `reach` metres, and as far as a vertex comes in a step of so
// many substeps at twice its speed.
struct ContactReach {
  double reach;
  int substeps;

  // Of a vertex that moves by q in a substep, from |q|^2.
  double of(double squaredWay) const { return reach + 2 * substeps * std::sqrt(squaredWay); }
};

// Vertices that may touch something within the running step. A vertex inside is put onto the surface (so its
// velocity into it is gone: contacts do not bounce), and loses up to `friction` times the depth of its
// sliding in the substep (Coulomb, as Mueller et al. 2007).
class Contacts {
 public:
  explicit Contacts(const Blocks& blocks) : blocks_(blocks), contacts_(blocks.count()) {}

  // Finds those of a block.
  void rebase(const Particles& particles, const Obstacles& obstacles, const ContactReach& reach,
              size_t block);
  void project(Particles& particles, float friction, size_t block) const;

 private:
  struct Contact {
    uint32_t vertex;
    bool flat;    // the ground: the obstacle lies where y is below 0
    Float4 base;  // of the vertex, from the start of the axis (or the floor), at the start of the step
    ContactSurface surface;
  };
  const Blocks& blocks_;
  std::vector<std::vector<Contact>> contacts_;  // by block
};

}  // namespace limber
