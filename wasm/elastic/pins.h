#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "linear/sparse_pencil.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// How many of the six rigid motions stay free while these points are fixed: 6 without a point, 3 with one
// point, 1 if all points are collinear, otherwise 0. Points closer than 1e-6 count as one, so the body should
// be of size 1.
uint32_t rigidMotionsLeft(const std::vector<Vec3>& points);
// The same for fixed vertices of a mesh.
uint32_t rigidMotionsLeft(const TriangleMesh& mesh, std::span<const uint32_t> pinned);

// Fixes unknowns at 0 by removing their couplings and their mass. The sparsity pattern of K does not change.
void clampUnknowns(SparsePencil& pencil, const std::vector<uint32_t>& unknowns);

// A point that moves as the weighted mean of eight nodes with three unknowns each.
struct EmbeddedPoint {
  const uint32_t* nodes;
  const double* weights;
};

// Ties a point inside an element to its rest position by springs of the given stiffness along x, y and z. The
// eight nodes must already be coupled.
void addPointSpring(SparsePencil& pencil, const EmbeddedPoint& point, double stiffness);

}  // namespace limber
