#include "simulate/contacts/contacts.h"

namespace limber {

void Contacts::rebase(const Particles& particles, const CollisionScene& scene,
                      const ContactDistance& distance, size_t block) {
  contacts_[block].clear();
  if (scene.empty()) return;
  for (uint32_t v = blocks_.start[block]; v < blocks_.start[block + 1]; ++v) {
    if (particles.inverseMass[v] == 0) continue;
    const Float4 q = particles.motion[v].q;
    forEachContactNear(particles.positions[v], distance.of(dot3(q, q)), scene,
                       [&](const PointContact& contact) { contacts_[block].push_back({v, contact}); });
  }
}

void Contacts::project(Particles& particles, float friction, size_t block) const {
  for (const Contact& contact : contacts_[block]) {
    Motion& motion = particles.motion[contact.vertex];
    const auto push = contact.point.pushAt(motion, friction);
    if (push) motion.q = (motion.q + push->out) - push->friction;
  }
}

}  // namespace limber
