#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulate/contacts/contact_surface.h"
#include "simulate/contacts/contacts.h"
#include "simulate/particles.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

// Contacts of the vertices of an embedded surface with the ground and colliders, as Contacts has them. The
// nodes of the cell share each correction by the weights of the vertex and their inverse masses.
class EmbeddedContacts {
 public:
  EmbeddedContacts(const LatticeBody& body, const Blocks& blocks);

  // Finds the vertices of a group that may touch something within the step. The scene is in metres.
  void rebase(const Particles& particles, const CollisionScene& scene, const ContactDistance& distance,
              size_t group);
  // One pass over the contacts of a group, in order.
  void project(Particles& particles, float friction, size_t group) const;

 private:
  struct Contact {
    uint32_t vertex;
    bool flat;    // the contact is with the ground, which fills y < 0
    Float4 base;  // the vertex relative to the start of the axis, or to the floor, at the start of the step
    ContactSurface surface;
    std::array<uint32_t, 8> nodes;
    std::array<float, 8> weights, shares;
  };
  void add(const Particles& particles, Contact contact, size_t group);

  const LatticeBody& body_;
  std::vector<std::vector<uint32_t>> vertices_;  // by group
  std::vector<std::vector<Contact>> contacts_;   // by group
};

}  // namespace limber
