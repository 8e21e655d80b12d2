#pragma once

#include <array>

#include "mesh/topology.h"
#include "simulate/sheet.h"

namespace limber {

// The cosine and sine of a fold angle, which is positive if the flap lies on the side of the triangle's
// normal.
struct Fold {
  double cosine, sine;
};
// The fold across the edge from `start` to `end` between the triangle (apex, start, end) and its flap.
Fold foldOf(const Vec3& apex, const Vec3& start, const Vec3& end, const Vec3& flap);

// flaps[3 t + e] is the vertex across edge e of triangle t (the edge opposite to corner e) that is not on the
// edge; kNone on a border. If more than two triangles meet at an edge, each takes the vertex of the next one.
std::vector<uint32_t> flapsOf(const TriangleMesh& mesh, const Topology& topology);

// The inverse of the stiffness of (s_0, s_1, s_2) in triangle t, entries 00 01 02 11 12 22, in rad2/J; see
// BendingConstraints.
std::array<double, 6> bendingCompliance(const TriangleMesh& mesh, uint32_t t, const Sheet& sheet);

// The inverse of the block of a compliance for the edges with `inner` set, entries 00 01 02 11 12 22; 0
// elsewhere.
std::array<double, 6> bendingStiffness(const std::array<double, 6>& compliance,
                                       const std::array<bool, 3>& inner);

}  // namespace limber
