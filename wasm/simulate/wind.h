#pragma once

#include <vector>

#include "mesh/topology.h"

namespace limber {

// A body in the air. SI units; all sizes are those of the mesh's vertices.
struct Airborne {
  const std::vector<Triangle>& triangles;
  const std::vector<Vec3>& positions;
  const std::vector<Vec3>& velocities;
  const std::vector<double>& masses;
  bool closed;  // then only the sides that face the wind are pressed
};

// The acceleration that air moving with `wind` gives each vertex, m/s2. Every triangle is pressed along its
// normal n by rho c A / 2 (w . n)^2, w its velocity against the air, rho = 1.2 kg/m3 and c = 1.2. It is held
// below what would stop the vertex against the air within half a step of `step` seconds, so that light cloth
// stays calm.
std::vector<Vec3> windAcceleration(const Airborne& body, const Vec3& wind, double step);

}  // namespace limber
