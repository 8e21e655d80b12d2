#pragma once

#include <cstdint>
#include <vector>

#include "simplify/collapse_mesh.h"
#include "simplify/constraints.h"
#include "simplify/cost/displacement_error.h"
#include "simplify/quadric.h"

namespace limber {

// The error of attributes that vary linearly over each triangle, in the compact form of Hoppe 1999.
//
// Triangle f of area a_f has the linear fields S_fj(p) = g_fj . p + d_fj, one for each attribute j. A sector
// has sums over the triangles that have become part of it. At point p its best value of attribute j is the
// area-weighted mean of S_fj(p), and the residual is
//   E(p) = sum_j [ sum_f a_f S_fj(p)^2 - (sum_f a_f S_fj(p))^2 / sum_f a_f ],
// which is 0 if all its triangles agree on one linear field. That is a quadric in p, which is added to those
// of the planes on each side of an edge, so that attributes enter both the error and the optimum. Values are
// multiplied by the diagonal of the bounding box, so that the sum is a squared length times an area.
//
// The first two attributes, texture coordinates, have weights per triangle, which multiply a_f for them.
//
// Displacements count in a metric, see addDisplacements: fully across the surface, and only little within it,
// where sliding is only visible in the texture; but fully where a border makes it visible.
class AttributeQuadrics {
 public:
  // Stores nothing if the constraints have no attributes.
  AttributeQuadrics(const CollapseMesh& mesh, const SimplifyConstraints& constraints);

  bool empty() const { return sums_.empty(); }
  // The error that the collapse of an edge leaves, summed over its sides; not divided by area.
  Quadric residual(uint32_t edge) const;
  // Must be called before the mesh carries out a collapse.
  void collapse(const Collapse& step);

 private:
  // The offset of the sums of fields, after a form, the area and the area for texture coordinates.
  static constexpr uint32_t kFields = kFormSize + 2;
  static constexpr uint32_t kTextureSize = 2;

  // The area of a triangle, and the part of it that counts for texture coordinates.
  struct Areas {
    double all, texture;
  };

  struct Joined {
    uint32_t sectors[2][2];  // on each side: the sector at the first vertex and that at the second
    int count;
  };

  void addTriangle(uint32_t t, const SimplifyConstraints& constraints);
  Joined sectorsAt(uint32_t edge, uint32_t first, uint32_t second) const;
  bool hasBorder(uint32_t t) const;
  void addScalars(double* sums, const LinearField* fields, const Areas& areas) const;
  Quadric residualOf(uint32_t first, uint32_t second) const;
  // The offset of the sums of displacements within those of a sector.
  uint32_t displacementsAt() const { return kFields + 4 * scalars_; }
  double* sumsOf(uint32_t sector) { return sums_.data() + size_t{sector} * stride_; }
  const double* sumsOf(uint32_t sector) const { return sums_.data() + size_t{sector} * stride_; }

  const CollapseMesh& mesh_;
  uint32_t dimension_ = 0, stride_ = 0;
  uint32_t scalars_ = 0, displacements_ = 0;  // dimension_ = scalars_ + 3 * displacements_
  // Per sector: sum over j, f of a g g^T (xx, xy, xz, yy, yz, zz), of a d g, of a d^2; the area and that for
  // texture coordinates; then for each attribute that is not a displacement the sums over f of a g and a d;
  // then those of displacements, see displacementSums.
  std::vector<double> sums_;
};

}  // namespace limber
