#include "simulate/solid/embedded_contacts.h"

#include "simulate/solid/embedded_points.h"

namespace limber {

EmbeddedContacts::EmbeddedContacts(const LatticeBody& body, const Blocks& blocks)
    : body_(body), vertices_(blocks.groupCount()), contacts_(blocks.groupCount()) {
  for (uint32_t v = 0; v < body.vertices.size(); ++v)
    vertices_[blocks.groupOf(body.cells[body.vertices[v].cell])].push_back(v);
}

void EmbeddedContacts::rebase(const Particles& particles, const CollisionScene& scene,
                              const ContactDistance& distance, size_t group) {
  contacts_[group].clear();
  if (scene.empty()) return;
  for (const uint32_t v : vertices_[group]) {
    const LatticePoint vertex = embeddedVertex(body_, v);
    const double near = distance.of(squaredLength(vertex.motion(particles)));
    forEachContactNear(vertex.position(particles), near, scene, [&](const PointContact& point) {
      contacts_[group].push_back(contactOf(particles, v, point));
    });
  }
}

EmbeddedContacts::Contact EmbeddedContacts::contactOf(const Particles& particles, uint32_t v,
                                                      const PointContact& point) const {
  const EmbeddedVertex& vertex = body_.vertices[v];
  Contact contact = {point, body_.cells[vertex.cell], {}, {}};
  double sum = 0;
  for (int k = 0; k < 8; ++k)
    sum += particles.inverseMass[contact.nodes[k]] * vertex.weights[k] * vertex.weights[k];
  for (int k = 0; k < 8; ++k) {
    contact.weights[k] = static_cast<float>(vertex.weights[k]);
    contact.shares[k] = static_cast<float>(particles.inverseMass[contact.nodes[k]] * vertex.weights[k] / sum);
  }
  return contact;
}

void EmbeddedContacts::project(Particles& particles, float friction, size_t group) const {
  for (const Contact& contact : contacts_[group]) {
    Motion moved{};
    for (int k = 0; k < 8; ++k) {
      const Motion& motion = particles.motion[contact.nodes[k]];
      moved.q += splat(contact.weights[k]) * motion.q;
      moved.u += splat(contact.weights[k]) * motion.u;
    }
    const auto push = contact.point.pushAt(moved, friction);
    if (!push) continue;
    const Float4 correction = push->out - push->friction;
    for (int k = 0; k < 8; ++k) particles.motion[contact.nodes[k]].q += splat(contact.shares[k]) * correction;
  }
}

}  // namespace limber
