#pragma once

#include <array>
#include <span>
#include <vector>

#include "elastic/solvers/constraint_strain.h"
#include "mesh/triangle_mesh.h"

namespace limber {

// Keeps the triangles of a body from collapsing in a large motion. A St. Venant-Kirchhoff sheet loses its
// stiffness when compressed below 1/sqrt(3), and triangles of springs resist no loss of area; but where
// a triangle has no area, the angles of its hinges jump, so that the energy has no minimum there.
//
// From an area ratio J = A / A0 of J0 = 1/sqrt(3) down a triangle has the energy 1/2 k A0 ln(J0 / J)^2, which
// is continuous with its derivative and has no bound. Above J0 it has none: small strains are those of the
// solver alone. For a triangle whose height at rest is less than 1e-4 of its longest edge it is lowered in
// the way of MembraneElement, and one of no area at rest has none.
class AreaBarrier {
 public:
  // `stiffness`: k in N/m, >= 0. Rest positions in metres. Copies what it needs.
  AreaBarrier(std::span<const std::array<uint32_t, 3>> triangles, std::span<const Vec3> rest,
              double stiffness);

  size_t count() const { return triangles_.size(); }
  const std::array<uint32_t, 3>& vertices(size_t i) const { return triangles_[i].vertices; }
  // Whether triangle i is so small that it resists.
  bool isActive(size_t i, std::span<const Vec3> positions) const;
  // One row, columns as those of a constraint with the three vertices.
  ConstraintStrain strainAt(size_t i, std::span<const Vec3> positions) const;
  // Of all triangles, in joules.
  double energyAt(std::span<const Vec3> positions) const;

 private:
  struct Triangle {
    std::array<uint32_t, 3> vertices;
    double root;        // sqrt(k A0)
    double doubleArea;  // 2 J0 A0: resists below
  };

  std::vector<Triangle> triangles_;
};

}  // namespace limber
