#pragma once

#include <vector>

#include "elastic/solid/lattice.h"

namespace limber {

// The mass of each node, rho = 1; none is negative, and their sum is the body's volume.
//
// Shape functions integrated over the filled parts put too much inertia into rotations and bending: a node at
// the body's end carries the mass of half a cell that lies inside of it, and the error is of the order of two
// cells over the thickness, squared. As in Gregory's correction of the trapezoidal rule, 1/12 of a cell's
// mass moves inwards by one cell wherever the body ends along an axis, which makes sums of quadratics over
// the nodes exact where the body ends at nodes, and exact on the average elsewhere.
std::vector<double> latticeMass(const Lattice& lattice, const Hexahedron& brick);

}  // namespace limber
