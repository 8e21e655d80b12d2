#pragma once

#include <array>

#include "mesh/topology.h"
#include "simulate/sheet.h"

namespace limber {

// A fold as its cosine and sine; positive where the flap rises to the side the triangle's normal points to.
struct Fold {
  double cosine, sine;
};
// Of the edge start -> end of triangle (apex, start, end) against its flap.
Fold foldOf(const Vec3& apex, const Vec3& start, const Vec3& end, const Vec3& flap);

// The vertex of each triangle's neighbour across edge e, [3 * t + e]; kNone on a border. On an edge of more
// than two triangles each has the next one's.
std::vector<uint32_t> flapsOf(const TriangleMesh& mesh, const Topology& topology);

// The inverse of the stiffness of (s_0, s_1, s_2) in triangle t, 00 01 02 11 12 22, in rad2/J; see
// BendingConstraints.
std::array<double, 6> bendingCompliance(const TriangleMesh& mesh, uint32_t t, const Sheet& sheet);

// The inverse of the part of a compliance that belongs to edges with `inner` set; 0 elsewhere.
std::array<double, 6> bendingStiffness(const std::array<double, 6>& compliance,
                                       const std::array<bool, 3>& inner);

}  // namespace limber
