#include "simulate/contacts/contacts.h"

#include <cmath>

#include "simulate/contacts/contact_surface.h"

namespace limber {

void Contacts::rebase(const Particles& particles, const CollisionScene& scene,
                      const ContactDistance& distance, size_t block) {
  contacts_[block].clear();
  if (scene.empty()) return;
  for (uint32_t v = blocks_.start[block]; v < blocks_.start[block + 1]; ++v) {
    if (particles.inverseMass[v] == 0) continue;
    const Vec3& x = particles.positions[v];
    const Float4 q = particles.motion[v].q;
    const double near = distance.of(dot3(q, q));
    if (scene.ground && x.y - *scene.ground < near)
      contacts_[block].push_back({v, true, toFloat4({0, x.y - *scene.ground, 0}), ContactSurface{}});
    for (const Collider& collider : scene.colliders) {
      if (distanceToAxis(x, collider) > collider.radius + near) continue;
      contacts_[block].push_back({v, false, toFloat4(x - collider.from), surfaceOf(collider)});
    }
  }
}

void Contacts::project(Particles& particles, float friction, size_t block) const {
  for (const Contact& contact : contacts_[block]) {
    Motion& motion = particles.motion[contact.vertex];
    Float4 normal = {0, 1, 0, 0};
    const Float4 point = contact.base + (motion.u + motion.q);
    float depth = -point[1];
    if (!contact.flat) {
      const Float4 outwards = point - contact.surface.nearestOnAxis(point);
      const float distance = std::sqrt(dot3(outwards, outwards));
      depth = contact.surface.radius - distance;
      if (distance > 0) normal = outwards / splat(distance);
    }
    if (!(depth > 0)) continue;
    motion.q += splat(depth) * normal;
    motion.q -= frictionOf(motion.q, normal, friction * depth);
  }
}

}  // namespace limber
