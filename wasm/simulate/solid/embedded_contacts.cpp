#include "simulate/solid/embedded_contacts.h"

#include <cmath>

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
    const LatticePoint point = embeddedVertex(body_, v);
    const Vec3 x = point.position(particles);
    const double near = distance.of(squaredLength(point.motion(particles)));
    if (scene.ground && x.y - *scene.ground < near)
      add(particles, {v, true, toFloat4({0, x.y - *scene.ground, 0}), ContactSurface{}, {}, {}, {}}, group);
    for (const Collider& collider : scene.colliders) {
      if (distanceToAxis(x, collider) > collider.radius + near) continue;
      add(particles, {v, false, toFloat4(x - collider.from), surfaceOf(collider), {}, {}, {}}, group);
    }
  }
}

void EmbeddedContacts::add(const Particles& particles, Contact contact, size_t group) {
  const EmbeddedVertex& vertex = body_.vertices[contact.vertex];
  contact.nodes = body_.cells[vertex.cell];
  double sum = 0;
  for (int k = 0; k < 8; ++k)
    sum += particles.inverseMass[contact.nodes[k]] * vertex.weights[k] * vertex.weights[k];
  for (int k = 0; k < 8; ++k) {
    contact.weights[k] = static_cast<float>(vertex.weights[k]);
    contact.shares[k] = static_cast<float>(particles.inverseMass[contact.nodes[k]] * vertex.weights[k] / sum);
  }
  contacts_[group].push_back(contact);
}

void EmbeddedContacts::project(Particles& particles, float friction, size_t group) const {
  for (const Contact& contact : contacts_[group]) {
    Float4 q{}, u{};
    for (int k = 0; k < 8; ++k) {
      const Motion& motion = particles.motion[contact.nodes[k]];
      q += splat(contact.weights[k]) * motion.q;
      u += splat(contact.weights[k]) * motion.u;
    }
    Float4 normal = {0, 1, 0, 0};
    const Float4 point = contact.base + (u + q);
    float depth = -point[1];
    if (!contact.flat) {
      const Float4 outwards = point - contact.surface.nearestOnAxis(point);
      const float distance = std::sqrt(dot3(outwards, outwards));
      depth = contact.surface.radius - distance;
      if (distance > 0) normal = outwards / splat(distance);
    }
    if (!(depth > 0)) continue;
    Float4 correction = splat(depth) * normal;
    correction -= frictionOf(q + correction, normal, friction * depth);
    for (int k = 0; k < 8; ++k) particles.motion[contact.nodes[k]].q += splat(contact.shares[k]) * correction;
  }
}

}  // namespace limber
