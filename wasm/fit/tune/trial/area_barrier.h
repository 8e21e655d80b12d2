#pragma once

#include <array>
#include <span>
#include <vector>

#include "elastic/solvers/constraint_strain.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// A barrier that keeps the triangles of a body from collapsing in a large motion. A St. Venant-Kirchhoff
// sheet softens once it is compressed beyond 1/sqrt(3), and triangles of springs do not resist a loss of area
// at all; but at zero area the angles of a triangle's hinges jump, so that the energy has no minimum there.
//
// Below an area ratio J = A / A0 of J0 = 1/sqrt(3) a triangle has the energy 1/2 k A0 ln(J0 / J)^2, which is
// unbounded and continuous together with its derivative. Above J0 the energy is 0: small strains are not
// affected. For a triangle whose height at rest is less than 1e-4 of its longest edge the energy is lowered
// as in MembraneElement, and for a triangle of zero area at rest it is 0.
class AreaBarrier {
 public:
  // `stiffness`: k in N/m, >= 0. Rest positions in metres. Copies what it needs.
  AreaBarrier(std::span<const std::array<uint32_t, 3>> triangles, std::span<const Vec3> rest,
              double stiffness);

  size_t count() const { return triangles_.size(); }
  const std::array<uint32_t, 3>& vertices(size_t i) const { return triangles_[i].vertices; }
  // Whether triangle i is compressed so much that the barrier acts.
  bool isActive(size_t i, std::span<const Vec3> positions) const;
  // One row; columns as for a constraint with the three vertices.
  ConstraintStrain strainAt(size_t i, std::span<const Vec3> positions) const;
  // Energy of all triangles, in joules.
  double energyAt(std::span<const Vec3> positions) const;

 private:
  struct Triangle {
    std::array<uint32_t, 3> vertices;
    double root;        // sqrt(k A0)
    double doubleArea;  // 2 J0 A0: the barrier acts below it
  };

  std::vector<Triangle> triangles_;
};

}  // namespace limber
