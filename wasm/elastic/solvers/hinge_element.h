#pragma once

#include <array>

#include "base/vec3.h"
#include "elastic/solvers/constraint_strain.h"
#include "elastic/solvers/solver_model.h"

namespace limber {

// Two triangles that fold about their common edge, of energy 1/2 k (theta - theta0)^2: the strain is sqrt(k)
// (theta - theta0). Vertices 0 and 1 are the ends of the edge, 2 and 3 the corners opposite to it.
//
// theta is the signed angle between the normals (x1 - x0) x (x2 - x0) and (x3 - x0) x (x1 - x0), so that the
// winding of the triangles in the mesh does not matter; theta - theta0 is taken between -pi and pi. Its
// gradients are those of Bridson et al. 2003 (Simulation of Clothing with Folds and Wrinkles): -(l/|n|^2) n
// with respect to the opposite corners, and their barycentric shares with respect to the ends of the edge.
//
// The stiffness against moving a corner of a flat triangle grows with the inverse square of its height. So if
// the height of a triangle at rest is less than kFlattestTriangle times its longest edge, k is lowered to
// give the stiffness at that height; a hinge with a triangle of zero area at rest has no stiffness. If a
// triangle loses its area in motion, its normal and the derivatives with respect to its opposite corner are
// 0.
class HingeElement {
 public:
  // `element`: HingeByArea, HingeByLength or Hinge; `bend` its constant in SI units, see BendElement, >= 0.
  // Rest positions in metres.
  HingeElement(BendElement element, double bend, const std::array<Vec3, 4>& rest);

  ConstraintStrain strainAt(const std::array<Vec3, 4>& positions) const;

 private:
  double root_, angle_ = 0;
};

}  // namespace limber
