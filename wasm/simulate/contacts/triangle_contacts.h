#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/blocks.h"
#include "simulate/contacts/contact_surface.h"
#include "simulate/contacts/contacts.h"
#include "simulate/particles.h"

namespace limber {

// Triangles that may touch a ball or a capsule within the running step between their corners, so that a
// coarse mesh lies on it as a fine one does. The point of a triangle that is nearest to the axis is put onto
// the surface, and loses as much of its sliding as a vertex does (see Contacts); the corners share both by
// the point's barycentric coordinates and their inverse masses. Only triangles whose longest edge at rest is
// more than kLeastEdge of the radius: the middle of others sinks in by less than 0.2 % of the radius.
class TriangleContacts {
 public:
  static constexpr double kLeastEdge = 0.1;

  // `mesh` at rest, in metres.
  TriangleContacts(const TriangleMesh& mesh, const Blocks& blocks);

  // Finds those of a group.
  void rebase(const Particles& particles, const Obstacles& obstacles, const ContactReach& reach,
              size_t group);
  // One pass over the group's, in order.
  void project(Particles& particles, float friction, size_t group) const;

 private:
  struct Candidate {
    Triangle corner;
    double longest;  // edge at rest, metres
  };
  struct Group {
    std::vector<Candidate> candidates;
    std::vector<uint32_t> vertices;  // of these, ascending
    double longest = 0;
  };
  struct Contact {
    Triangle corner;
    Float4 base[3];  // of the corners, from the start of the axis, at the start of the step
    float weight[3];
    ContactSurface surface;
    float reach;  // corner 0 is nearer to the axis than this, in metres, where the triangle touches
  };
  void addContacts(const Particles& particles, const Collider& collider, const ContactReach& reach,
                   size_t group);

  std::vector<Group> groups_;
  std::vector<std::vector<Contact>> contacts_;  // by group
};

}  // namespace limber
