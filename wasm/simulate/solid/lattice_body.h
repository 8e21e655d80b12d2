#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "base/job.h"
#include "elastic/material.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A cell of a lattice has 24 displacements: eight amplitudes for each axis, a_m = sum_k s_mk x_k. Bit i of
// the mask m tells whether the sign s_mk depends on the side of corner k along axis i (Walsh-Hadamard
// transform). Mask 0 is the translation, masks 1, 2 and 4 are linear in the position, and the following four
// bend the cell (hourglass modes). They are 0 at rest.
inline constexpr std::array<int, 4> kHourglassMasks = {3, 5, 6, 7};

// The sign of corner k in the amplitude of a mask.
constexpr int amplitudeSign(int mask, int corner) {
  int sign = 1;
  for (int axis = 0; axis < 3; ++axis)
    if ((mask >> axis & 1) && !(corner >> axis & 1)) sign = -sign;
  return sign;
}

// The elastic properties of one cell, in SI units.
struct CellRest {
  Vec3 size;      // m, of the whole cell
  double volume;  // m3, of its filled part
  // The means of xi, eta, zeta, eta zeta, zeta xi and xi eta over the filled part. The coordinates run from
  // -1 to 1 within the cell.
  std::array<double, 6> moments;
  // Stiffness of the hourglass amplitudes in N/m: row and column 3 i + axis for mask kHourglassMasks[i].
  Eigen::Matrix<double, 12, 12> hourglass;
};

// The mean gradients of the corners' trilinear weights over the filled part, 1/m for a size in m. The mean
// deformation gradient is sum_k x_k gradient_k^T.
std::array<Vec3, 8> meanGradients(const Vec3& size, const std::array<double, 6>& moments);

// The position of a vertex of the surface: its cell, and the trilinear weights of the cell's corners.
struct EmbeddedVertex {
  uint32_t cell = 0;
  std::array<double, 8> weights{};
};

// Closed bodies as lattices in SI units.
struct LatticeBody {
  std::vector<Vec3> nodes;     // m, at rest
  std::vector<double> masses;  // kg, of nodes, > 0
  std::vector<std::array<uint32_t, 8>> cells;
  std::vector<CellRest> rest;            // by cell
  std::vector<EmbeddedVertex> vertices;  // by vertex of the surface
};

// The lattices of all closed components of `solids`, each together with its cavities; no component may be
// open. `cellSize` is in units of the mesh; see latticeGrid. At rest the stiffness is that of the solid modes
// (elastic/solid/solid.h): each cell's matrix is split into that of its mean strain and a remainder, which
// acts only on its hourglass amplitudes. Masses are those of the solid modes too, except that light nodes get
// at least a share of their neighbours' mass, because in motion every node needs some. Throws Cancelled.
LatticeBody latticeBody(const TriangleMesh& solids, const Vec3& cellSize, const ElasticMaterial& material,
                        Job& job);

// The cell size for a body and for all bodies that it is compared with: it gives about as many cells as the
// solid modes use. `mesh` may have open components, which do not count. 0 if no component is closed.
Vec3 solidCellSize(const TriangleMesh& mesh);

// Per component of a mesh whether it is a solid or bounds one of its cavities.
std::vector<uint8_t> solidComponents(const TriangleMesh& mesh);

}  // namespace limber
