#pragma once

#include <span>
#include <vector>

#include "simulate/solid/lattice_body.h"

namespace limber {

// The velocities of nodes that best fit those of the surface's vertices, velocities[v] for the first of its
// vertices: they minimise sum_v |velocity of the embedded vertex - velocities[v]|^2, and the nodes that the
// vertices leave undetermined, mainly in the inside, are extrapolated with the least second differences along
// the lattice. Velocities that are linear in the position are reproduced exactly. O(n^2) at most in the nodes
// (sparse Cholesky).
std::vector<Vec3> fitVelocities(const LatticeBody& body, std::span<const Vec3> velocities);

}  // namespace limber
