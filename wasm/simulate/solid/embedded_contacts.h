#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "simulate/blocks.h"
#include "simulate/contacts/point_contact.h"
#include "simulate/particles.h"
#include "simulate/solid/lattice_body.h"

namespace limber {

// Contacts of the vertices of an embedded surface with the ground and colliders, as in Contacts. Each
// correction is distributed to the nodes of the cell by the weights of the vertex and their inverse masses.
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
    PointContact point;
    std::array<uint32_t, 8> nodes;
    std::array<float, 8> weights, shares;
  };
  // The contact of a vertex of the surface.
  Contact contactOf(const Particles& particles, uint32_t v, const PointContact& point) const;

  const LatticeBody& body_;
  std::vector<std::vector<uint32_t>> vertices_;  // by group
  std::vector<std::vector<Contact>> contacts_;   // by group
};

}  // namespace limber
