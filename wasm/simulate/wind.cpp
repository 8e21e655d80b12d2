#include "simulate/wind.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kAirDensity = 1.2, kDrag = 1.2;

}  // namespace

std::vector<Vec3> windAcceleration(const Airborne& body, const Vec3& wind, double step) {
  std::vector<Vec3> acceleration(body.masses.size());
  for (const Triangle& t : body.triangles) {
    const Vec3 &a = body.positions[t[0]], &b = body.positions[t[1]], &c = body.positions[t[2]];
    const Vec3 doubleArea = cross(b - a, c - a), normal = normalized(doubleArea);
    const Vec3 own = (body.velocities[t[0]] + body.velocities[t[1]] + body.velocities[t[2]]) / 3;
    const double across = dot(wind - own, normal);
    if (body.closed && across >= 0) continue;
    const double force = 0.25 * kAirDensity * kDrag * length(doubleArea) * std::abs(across) * across;
    for (const uint32_t v : t)
      if (body.masses[v] > 0) acceleration[v] += normal * (force / (3 * body.masses[v]));
  }
  for (size_t v = 0; v < acceleration.size(); ++v) {
    const double size = length(acceleration[v]);
    const double most = length(wind - body.velocities[v]) / (0.5 * step);
    if (size > most) acceleration[v] *= most / size;
  }
  return acceleration;
}

}  // namespace limber
