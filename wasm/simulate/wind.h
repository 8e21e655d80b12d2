#pragma once

#include <vector>

#include "mesh/topology.h"

namespace limber {

// A body in the air, in SI units; every array has one entry per vertex. Air does not move a vertex without
// mass, such as one whose triangles all have no area.
struct Airborne {
  const std::vector<Triangle>& triangles;
  const std::vector<Vec3>& positions;
  const std::vector<Vec3>& velocities;
  const std::vector<double>& masses;
  bool closed;  // the body has no border: air presses only on triangles that face the wind
};

// The acceleration of every vertex by air that moves with `wind` (m/s), in m/s2. The force rho c A / 2 |w .
// n| (w . n) acts on every triangle along its unit normal n and is shared equally by its corners; w is the
// velocity of the air relative to the triangle, A its area, rho = 1.2 kg/m3 the density of air and c = 1.2
// the drag coefficient of a flat plate. The acceleration is limited to one that would bring a vertex to the
// velocity of the air within half a step of `step` seconds, so that light cloth does not flutter.
std::vector<Vec3> windAcceleration(const Airborne& body, const Vec3& wind, double step);

}  // namespace limber
