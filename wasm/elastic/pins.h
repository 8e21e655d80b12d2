#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "linear/stiffness_model.h"

namespace limber {

// How many of the six rigid motions stay free while these points of a body of size 1 are held: 6 without a
// point, 3 with one, 1 where all lie on a line, otherwise 0.
uint32_t rigidMotionsLeft(const std::vector<Vec3>& held);

// Holds unknowns at 0: they lose their couplings and their mass. Blocks stay stored, so the structure does
// not change.
void holdUnknowns(StiffnessModel& model, const std::vector<uint32_t>& unknowns);

// A point that moves as the weighted mean of eight nodes with three unknowns each.
struct EmbeddedPoint {
  const uint32_t* nodes;
  const double* weights;
};

// Holds a point inside an element by a spring of the given stiffness along each axis. The eight nodes must be
// coupled already.
void holdPoint(StiffnessModel& model, const EmbeddedPoint& point, double stiffness);

}  // namespace limber
