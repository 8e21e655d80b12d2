#pragma once

#include <cstdint>

namespace limber {

// The solvers of the panel: how the soft bodies of game engines and simulators discretise a thin surface, as
// a combination of an element that resists stretching, one that resists bending, and a rule for masses.

// Membrane: constant-strain triangles (CST) of a St. Venant-Kirchhoff sheet in plane stress.
// EdgeSprings: 1/2 k (|x_i - x_j| - L)^2 on every edge, one k for all.
enum class StretchElement : int32_t { Membrane = 0, EdgeSprings = 1 };

// theta is the dihedral angle of an interior edge of length l between triangles of areas A1 and A2.
// Morley: constant curvature in each triangle, as elastic/shell.h.
// HingeByArea: 1/2 (3 D l^2 / (A1 + A2)) (theta - theta0)^2 (Grinspun et al. 2003, Discrete Shells).
// HingeByLength: 1/2 k l (theta - theta0)^2.
// Hinge: 1/2 k (theta - theta0)^2, one k for all.
// CrossSprings: 1/2 k (|x_k - x_l| - L)^2 between the two corners opposite each interior edge, one k for all.
enum class BendElement : int32_t {
  Morley = 0,
  HingeByArea = 1,
  HingeByLength = 2,
  Hinge = 3,
  CrossSprings = 4
};

// Area: proportional to a third of the area around a vertex. Vertex: the same mass for every vertex.
enum class MassRule : int32_t { Area = 0, Vertex = 1 };

struct SolverModel {
  StretchElement stretch = StretchElement::Membrane;
  BendElement bend = BendElement::HingeByArea;
  MassRule mass = MassRule::Area;
};

// The constants of a solver on one mesh, in SI units.
struct SolverConstants {
  double stretch = 0;        // EdgeSprings: k, N/m. Membrane: shear modulus times thickness, N/m. > 0
  double secondStretch = 0;  // Membrane: the plane-stress Lame constant lambda times the thickness, N/m
  double bend = 0;       // Morley, HingeByArea: D, N m. HingeByLength: N. Hinge: N m. CrossSprings: N/m. >= 0
  double poisson = 0.3;  // only for Morley
  double surfaceDensity = 0;  // total mass over area, kg/m2, > 0
  double unit = 1;            // metres per unit of the mesh, > 0
};

}  // namespace limber
