#pragma once

#include <Eigen/Core>

#include "mesh/triangle_mesh.h"

namespace limber {

// The generalised strains of one triangle of a shell: constant strain for the membrane, and the constant
// curvature of Morley's element (Morley 1968) for bending; see elastic/shell.h for the formulas.
//
// Columns are the element's unknowns: nine displacements (3 * corner + axis), then the rotations of the edges
// opposite to corners 0, 1, 2. Rows are xx, yy, 2 xy along two axes in the triangle's plane; for a tie they
// are the gaps that it closes.
struct ShellElement {
  using Strain = Eigen::Matrix<double, 3, 12>;

  // Whether the corners are collinear, so that there is no plane. The element then ties the middle corner to
  // the longest edge and makes the edge rotations on both sides equal: the limit of an ever flatter triangle.
  // Without the tie a crack would open wherever such a triangle closes a surface. The stiffness of a tie is E
  // h and E h^3 / 12 divided by kFlattestTriangle.
  bool isTie = false;
  double weight = 0;  // the area, reduced if flatter than kFlattestTriangle; 0 for a tie
  Strain strain = Strain::Zero(), curvature = Strain::Zero();
};

ShellElement shellElement(const TriangleMesh& mesh, uint32_t t);

// For shells, and the membranes and hinges of solvers: a triangle flatter than this (height over longest
// edge) gets the stiffness of one of this flatness, because the true stiffness grows with 1 / flatness, and
// its rounding errors would swamp the rest of the body. It still keeps its vertices together.
inline constexpr double kFlattestTriangle = 1e-4;
// A triangle flatter than this counts as collinear.
inline constexpr double kDegenerateTriangle = 1e-12;

// The stiffness that is added to an edge rotation with ties as its only elements, relative to the bending
// stiffness of the tie: enough to keep K regular, too little to matter.
inline constexpr double kLooseRotation = 1e-10;

}  // namespace limber
