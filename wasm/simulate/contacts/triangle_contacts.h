#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "simulate/blocks.h"
#include "simulate/contacts/contact_surface.h"
#include "simulate/contacts/point_contact.h"
#include "simulate/particles.h"

namespace limber {

// Contacts of the interior of triangles with balls and capsules, so that a coarse mesh rests on them as a
// fine one does. The point of a triangle that is nearest to the axis is moved onto the surface, with the same
// friction as for a vertex (see Contacts); both corrections are distributed to the corners by the barycentric
// coordinates of the point and their inverse masses. Only triangles whose longest edge at rest exceeds
// kMinEdge times the radius take part: the middle of smaller ones sinks in by less than 0.2 % of the
// radius.
class TriangleContacts {
 public:
  static constexpr double kMinEdge = 0.1;

  // `mesh` at rest, in metres.
  TriangleContacts(const TriangleMesh& mesh, const Blocks& blocks);

  // Finds the triangles of a group that may touch a collider within the step. The scene is in metres.
  void rebase(const Particles& particles, const CollisionScene& scene, const ContactDistance& distance,
              size_t group);
  // One pass over the contacts of a group, in order.
  void project(Particles& particles, float friction, size_t group) const;

 private:
  struct Candidate {
    Triangle corner;
    double longest;  // edge at rest, metres
  };
  struct Group {
    std::vector<Candidate> candidates;
    std::vector<uint32_t> vertices;  // of the candidates, ascending
    double longest = 0;              // edge of the candidates at rest, metres
  };
  struct Contact {
    Triangle corner;
    Float4 base[3];   // the corners relative to the start of the axis, at the start of the step
    float weight[3];  // 1/kg
    ContactSurface surface;
    float touchingDistance;  // metres: a triangle whose corner 0 is farther from the axis cannot touch
  };
  void addContacts(const Particles& particles, const Collider& collider, const ContactDistance& distance,
                   size_t group);

  std::vector<Group> groups_;
  std::vector<std::vector<Contact>> contacts_;  // by group
};

}  // namespace limber
