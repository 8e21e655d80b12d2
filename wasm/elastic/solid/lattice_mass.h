#pragma once

#include <vector>

#include "elastic/solid/lattice.h"

namespace limber {

// The mass of each node for rho = 1. Masses are nonnegative; their sum is the volume of the body.
//
// Shape functions integrated over the filled parts overestimate the inertia of rotations and bending: a node
// at the end of the body carries the mass of half a cell that lies further inside. The relative error is of
// the order of the square of two cells over the thickness. As in Gregory's correction of the trapezoidal
// rule, 1/12 of the mass of a cell is moved inwards by one cell wherever the body ends along an axis. Sums of
// quadratic functions over the nodes are then exact where the body ends at nodes, and exact on average
// elsewhere.
std::vector<double> latticeMass(const Lattice& lattice, const Hexahedron& brick);

}  // namespace limber
