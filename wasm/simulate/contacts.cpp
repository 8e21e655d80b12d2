#include "simulate/contacts.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

float dot3(Float4 a, Float4 b) {
  const Float4 product = a * b;
  return product[0] + product[1] + product[2];
}

double distanceToAxis(const Vec3& point, const Collider& collider) {
  const Vec3 axis = collider.to - collider.from, offset = point - collider.from;
  const double squared = squaredLength(axis);
  const double along = squared > 0 ? std::clamp(dot(offset, axis) / squared, 0.0, 1.0) : 0;
  return length(offset - axis * along);
}

}  // namespace

void Contacts::rebase(const Particles& particles, const Obstacles& obstacles, const ContactReach& reach,
                      size_t block) {
  contacts_[block].clear();
  if (obstacles.empty()) return;
  for (uint32_t v = blocks_.start[block]; v < blocks_.start[block + 1]; ++v) {
    if (particles.inverseMass[v] == 0) continue;
    const Vec3& x = particles.positions[v];
    const Float4 q = particles.motion[v].q;
    const double near = reach.reach + 2 * reach.substeps * std::sqrt(double{dot3(q, q)});
    if (obstacles.ground && x.y - *obstacles.ground < near)
      contacts_[block].push_back({v, true, toFloat4({0, x.y - *obstacles.ground, 0}), Float4{}, 0, 0});
    for (const Collider& collider : obstacles.colliders) {
      if (distanceToAxis(x, collider) > collider.radius + near) continue;
      const Vec3 axis = collider.to - collider.from;
      const double squared = squaredLength(axis);
      contacts_[block].push_back({v, false, toFloat4(x - collider.from), toFloat4(axis),
                                  squared > 0 ? static_cast<float>(1 / squared) : 0.0f,
                                  static_cast<float>(collider.radius)});
    }
  }
}

void Contacts::project(Particles& particles, float friction, size_t block) const {
  for (const Contact& contact : contacts_[block]) {
    Motion& motion = particles.motion[contact.vertex];
    Float4 normal = {0, 1, 0, 0};
    const Float4 place = contact.base + (motion.u + motion.q);
    float depth = -place[1];
    if (!contact.flat) {
      const float along = std::clamp(dot3(place, contact.axis) * contact.inverseSquare, 0.0f, 1.0f);
      const Float4 outwards = place - splat(along) * contact.axis;
      const float distance = std::sqrt(dot3(outwards, outwards));
      depth = contact.radius - distance;
      if (distance > 0) normal = outwards / splat(distance);
    }
    if (!(depth > 0)) continue;
    motion.q += splat(depth) * normal;
    const Float4 sliding = motion.q - splat(dot3(motion.q, normal)) * normal;
    const float slid = std::sqrt(dot3(sliding, sliding));
    if (slid > 0) motion.q -= splat(std::min(1.0f, friction * depth / slid)) * sliding;
  }
}

}  // namespace limber
