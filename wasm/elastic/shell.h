#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linear/stiffness_model.h"
#include "mesh/topology.h"

namespace limber {

// A thin shell of Young's modulus 1 and density 1: constant-strain membrane plus Morley bending. Three
// displacements per vertex (nodes 0 .. vertexCount - 1) and one massless rotation about each edge (the nodes
// after them). kappa_T = sum_e (l_e / A) (s_e phi_e - theta_e(u)) m_e m_e^T, theta_e(u) = -d(u . n) / d m_e,
// m_e the outward in-plane normal of edge e, s_e = +1 where the face runs the edge from its lower to its
// higher vertex; energy A D / 2 ((1 - nu) kappa : kappa + nu tr^2 kappa), D = h^3 / 12 (1 - nu^2). Holds for
// any number of faces on an edge and for any winding. `thickness` in units of the mesh, which should be
// scaled to a bounding diagonal of 1.
StiffnessModel shellModel(const TriangleMesh& mesh, const Topology& topology, double thickness,
                          double poisson);

// A rough size of its first elastic eigenvalue where the bounding diagonal is 1: 40 h^2 for a free strip, 60
// for a plate, 100 to 2000 for most closed bodies.
inline double roughFirstEigenvalue(double thickness, bool isPinned) {
  return (isPinned ? 30 : 300) * thickness * thickness;
}

// What pinned vertices hold: their displacements; and a face that is pinned whole holds the slopes at its
// edges too, so that a pinned patch clamps what is around it, while a pinned line is a hinge.
std::vector<uint32_t> heldUnknowns(const TriangleMesh& mesh, const Topology& topology,
                                   std::span<const uint32_t> pinned);

// Three translations and three rotations, a column each, over the displacements of a shell.
Eigen::MatrixXd rigidMotions(const TriangleMesh& mesh);

}  // namespace limber
