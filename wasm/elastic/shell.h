#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linear/sparse_pencil.h"
#include "mesh/topology.h"

namespace limber {

// A thin shell with E = rho = 1. It keeps references to mesh and topology, which must outlive it.
struct ThinShell {
  const TriangleMesh& mesh;
  const Topology& topology;  // of the mesh
  double thickness;          // h, in units of the mesh, > 0
  double poisson;            // nu, in (-1, 0.5)
};

// Stiffness and mass of a shell: constant-strain triangles (CST) for the membrane and Morley's element
// (Morley 1968) for bending.
//
// Unknowns: three displacements per vertex, u(3 v + c), then one massless rotation per edge, psi(3
// vertexCount + e). The curvature is constant in each triangle T of area A:
//   kappa_T = sum_e (l_e / A) (s_e psi_e - theta_e(u)) m_e m_e^T,   theta_e(u) = -d(u . n) / d m_e
// with edge lengths l_e, outward in-plane edge normals m_e, and s_e = +1 if T traverses the edge from its
// lower to its higher vertex, else -1. The energy of a triangle is A D / 2 ((1 - nu) kappa : kappa + nu tr^2
// kappa), D = h^3 / (12 (1 - nu^2)), plus that of its membrane. Valid for any number of faces on an edge and
// any winding. Triangles flatter than kFlattestTriangle (1e-4) get the stiffness of one of that flatness;
// those without area become ties.
//
// The mesh should be scaled to a bounding diagonal of 1. O(n) time and memory.
SparsePencil shellPencil(const ThinShell& shell);

// The same pencil with all values 0, for factorStructure: the sparsity pattern is the same for every
// thickness and all positions.
SparsePencil shellPattern(const TriangleMesh& mesh, const Topology& topology);

// A rough size of the first elastic eigenvalue of a shell with a bounding diagonal of 1. Measured: 40 h^2 for
// a free strip, 60 h^2 for a plate, 100 to 2000 h^2 for most closed bodies.
inline double roughFirstEigenvalue(double thickness, bool isPinned) {
  return (isPinned ? 30 : 300) * thickness * thickness;
}

// The unknowns that pinned vertices fix: their displacements and, in triangles with three pinned vertices,
// the edge rotations. A pinned patch therefore clamps the surrounding surface, while a pinned line is a
// hinge.
std::vector<uint32_t> clampedUnknowns(const TriangleMesh& mesh, const Topology& topology,
                                      std::span<const uint32_t> pinned);

// Three translations and three linearised rotations as columns over the displacements: (3 v + c) x 6.
Eigen::MatrixXd rigidMotions(const TriangleMesh& mesh);

}  // namespace limber
