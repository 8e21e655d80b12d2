#pragma once

#include <Eigen/Core>

#include "mesh/triangle_mesh.h"

namespace limber {

// The generalised strains of one triangle of a shell: constant strain for the membrane, and the constant
// curvature of Morley's element (Morley 1968) for bending; see elastic/shell.h for the formulas.
//
// Columns are the element's unknowns: nine displacements (3 * corner + axis), then the rotations of the edges
// opposite to corners 0, 1, 2. Rows are xx, yy, 2 xy along two axes in the triangle's plane; for a tie they
// are gaps.
struct ShellElement {
  using Strain = Eigen::Matrix<double, 3, 12>;

  // Whether the corners lie on a line, so that there is no plane. The element then ties the middle corner to
  // the longest edge and makes the edge rotations on both sides equal: the limit of a triangle that flattens.
  // Without it a crack would open wherever such a triangle closes a surface. The stiffness of a tie is E h
  // and E h^3 / 12 divided by kFlattestTriangle.
  bool isTie = false;
  double weight = 0;  // the area, less in a triangle flatter than kFlattestTriangle; 0 for a tie
  Strain strain = Strain::Zero(), curvature = Strain::Zero();
};

ShellElement shellElement(const TriangleMesh& mesh, uint32_t t);

// Shells, and the membranes and hinges of solvers: a triangle flatter than this (height over longest edge)
// gets the stiffness of one that is just as flat, for real stiffness grows with 1 / flatness and would drown
// the rest of the body in rounding. It still keeps its vertices together.
inline constexpr double kFlattestTriangle = 1e-4;
// A triangle flatter than this has no plane.
inline constexpr double kDegenerateTriangle = 1e-12;

// The stiffness of an edge rotation that only ties hold, relative to the bending stiffness of the tie: enough
// to keep K regular, too little to matter.
inline constexpr double kLooseRotation = 1e-10;

}  // namespace limber
