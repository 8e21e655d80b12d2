#include "simulate/contacts/triangle_contacts.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

// How often the nearest points of a triangle and an axis are improved, each from the other. A few rounds
// suffice, because any pair that is closer than the radius is a true contact.
constexpr int kRounds = 4;
// A corner moves at most this many times as far as the contact point, even if the other corners are pinned.
constexpr float kMaxLeverage = 10;

// How far the longest edge of a triangle is assumed to stretch within a step, as a factor.
constexpr double kMaxStretch = 1.25;

using Shares = std::array<float, 3>;

Float4 pointAt(const Float4 (&corner)[3], const Shares& share) {
  return splat(share[0]) * corner[0] + splat(share[1]) * corner[1] + splat(share[2]) * corner[2];
}

// The parameter of the point of a segment that is nearest to the origin: 0 at its start, 1 at its end.
float shareOfEnd(Float4 start, Float4 end) {
  const Float4 along = end - start;
  const float squared = dot3(along, along);
  return squared > 0 ? std::clamp(-dot3(start, along) / squared, 0.0f, 1.0f) : 0;
}

// The barycentric coordinates of the point of a triangle that is nearest to the origin: the foot on its
// plane, or the nearest point of its edges if the foot lies outside.
Shares nearestShares(const Float4 (&corner)[3]) {
  const Float4 edge1 = corner[1] - corner[0], edge2 = corner[2] - corner[0];
  const float g11 = dot3(edge1, edge1), g12 = dot3(edge1, edge2), g22 = dot3(edge2, edge2);
  const float r1 = -dot3(corner[0], edge1), r2 = -dot3(corner[0], edge2);
  const float squaredArea = g11 * g22 - g12 * g12;
  const float b = g22 * r1 - g12 * r2, c = g11 * r2 - g12 * r1;
  if (b >= 0 && c >= 0 && b + c <= squaredArea && squaredArea > 0)
    return {1 - (b + c) / squaredArea, b / squaredArea, c / squaredArea};
  Shares best = {1, 0, 0};
  float least = INFINITY;
  for (int e = 0; e < 3; ++e) {
    const int f = (e + 1) % 3;
    Shares share = {0, 0, 0};
    share[f] = shareOfEnd(corner[e], corner[f]);
    share[e] = 1 - share[f];
    const Float4 point = pointAt(corner, share);
    const float squared = dot3(point, point);
    if (squared >= least) continue;
    least = squared;
    best = share;
  }
  return best;
}

// The same for the axis of a collider instead of the origin; `outwards` is the vector from the axis to the
// point.
Shares nearestShares(const Float4 (&corner)[3], const ContactSurface& surface, Float4& outwards) {
  Shares share = {1.0f / 3, 1.0f / 3, 1.0f / 3};
  const int rounds = surface.inverseSquare > 0 ? kRounds : 1;
  for (int round = 0; round < rounds; ++round) {
    const Float4 center = surface.nearestOnAxis(pointAt(corner, share));
    const Float4 seen[3] = {corner[0] - center, corner[1] - center, corner[2] - center};
    share = nearestShares(seen);
    outwards = pointAt(seen, share);
  }
  return share;
}

// The bounding box of vertices, and the largest squared motion of one in a substep.
struct MovingBox {
  Bounds box;
  double fastest = 0;  // m2
};
MovingBox movingBoxOf(const Particles& particles, const std::vector<uint32_t>& vertices) {
  const Vec3& first = particles.positions[vertices.front()];
  MovingBox moving = {{first, first}};
  for (const uint32_t v : vertices) {
    const Vec3& p = particles.positions[v];
    for (int c = 0; c < 3; ++c) {
      moving.box.low[c] = std::min(moving.box.low[c], p[c]);
      moving.box.high[c] = std::max(moving.box.high[c], p[c]);
    }
    const Float4 q = particles.motion[v].q;
    moving.fastest = std::max(moving.fastest, double{dot3(q, q)});
  }
  return moving;
}

}  // namespace

TriangleContacts::TriangleContacts(const TriangleMesh& mesh, const Blocks& blocks)
    : groups_(blocks.groupCount()), contacts_(blocks.groupCount()) {
  for (const Triangle& t : mesh.triangles) {
    double longest = 0;
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, length(mesh.positions[t[c]] - mesh.positions[t[(c + 1) % 3]]));
    Group& group = groups_[blocks.groupOf(t)];
    group.candidates.push_back({t, longest});
    group.vertices.insert(group.vertices.end(), t.begin(), t.end());
    group.longest = std::max(group.longest, longest);
  }
  for (Group& group : groups_) {
    std::sort(group.vertices.begin(), group.vertices.end());
    group.vertices.erase(std::unique(group.vertices.begin(), group.vertices.end()), group.vertices.end());
  }
}

void TriangleContacts::rebase(const Particles& particles, const CollisionScene& scene,
                              const ContactDistance& distance, size_t group) {
  contacts_[group].clear();
  if (scene.colliders.empty() || groups_[group].candidates.empty()) return;
  const MovingBox moving = movingBoxOf(particles, groups_[group].vertices);
  const Vec3 center = (moving.box.low + moving.box.high) * 0.5;
  const double near = distance.of(moving.fastest);
  for (const Collider& collider : scene.colliders) {
    if (groups_[group].longest <= kMinEdge * collider.radius) continue;
    if (distanceToAxis(center, collider) > collider.radius + near + 0.5 * moving.box.diagonal()) continue;
    addContacts(particles, collider, distance, group);
  }
}

void TriangleContacts::addContacts(const Particles& particles, const Collider& collider,
                                   const ContactDistance& distance, size_t group) {
  const ContactSurface surface = surfaceOf(collider);
  for (const auto& [corner, longest] : groups_[group].candidates) {
    if (longest <= kMinEdge * collider.radius) continue;
    Contact contact = {corner, {}, {}, surface, 0};
    float heaviest = 0;
    double farthest = 0, fastest = 0;
    const Vec3& origin = particles.positions[corner[0]];
    for (int c = 0; c < 3; ++c) {
      const Vec3& position = particles.positions[corner[c]];
      contact.base[c] = toFloat4(position - collider.from);
      contact.weight[c] = static_cast<float>(particles.inverseMass[corner[c]]);
      heaviest = std::max(heaviest, contact.weight[c]);
      farthest = std::max(farthest, length(position - origin));
      const Float4 q = particles.motion[corner[c]].q;
      fastest = std::max(fastest, double{dot3(q, q)});
    }
    const double near = distance.of(fastest);
    contact.touchingDistance = static_cast<float>(collider.radius + kMaxStretch * farthest);
    if (heaviest > 0 && distanceToAxis(origin, collider) < collider.radius + near + farthest)
      contacts_[group].push_back(contact);
  }
}

void TriangleContacts::project(Particles& particles, float friction, size_t group) const {
  for (const Contact& contact : contacts_[group]) {
    Motion* motion[3];
    Float4 corner[3], outwards;
    for (int c = 0; c < 3; ++c) {
      motion[c] = &particles.motion[contact.corner[c]];
      corner[c] = contact.base[c] + (motion[c]->u + motion[c]->q);
    }
    const Float4 fromAxis = corner[0] - contact.surface.nearestOnAxis(corner[0]);
    if (dot3(fromAxis, fromAxis) > contact.touchingDistance * contact.touchingDistance) continue;
    const Shares share = nearestShares(corner, contact.surface, outwards);
    const float squared = dot3(outwards, outwards), radius = contact.surface.radius;
    if (squared >= radius * radius || !(squared > 0)) continue;
    const float distance = std::sqrt(squared), depth = radius - distance;
    const Float4 q = pointAt({motion[0]->q, motion[1]->q, motion[2]->q}, share);
    const ContactPush push = pushOf(q, outwards / splat(distance), depth, friction);
    const Float4 correction = push.out - push.friction;
    float weight = 0, largest = 0;
    for (int c = 0; c < 3; ++c) {
      const float moved = contact.weight[c] * share[c];
      weight += moved * share[c];
      largest = std::max(largest, moved);
    }
    weight = std::max(weight, largest / kMaxLeverage);
    for (int c = 0; c < 3 && weight > 0; ++c)
      motion[c]->q += splat(contact.weight[c] * share[c] / weight) * correction;
  }
}

}  // namespace limber
