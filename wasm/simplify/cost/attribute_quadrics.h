#pragma once

#include <cstdint>
#include <vector>

#include "simplify/collapse_mesh.h"
#include "simplify/constraints.h"
#include "simplify/quadric.h"

namespace limber {

// The error of attributes that vary linearly over each triangle, in the compact form of Hoppe 1999.
//
// Triangle f of area a_f has the linear fields S_fj(p) = g_fj . p + d_fj, one for each attribute j. A sector
// holds sums over the triangles that have become part of it. At point p its best value of attribute j is the
// area-weighted mean of S_fj(p), and what remains is
//   E(p) = sum_j [ sum_f a_f S_fj(p)^2 - (sum_f a_f S_fj(p))^2 / sum_f a_f ],
// 0 where all its triangles agree on one linear field. That is a quadric in p, which the cost model adds to
// those of the planes on each side of an edge: so the attributes count in the error and in the placement.
// Values are multiplied by the bounding diagonal, so that the sum is a squared length times an area.
class AttributeQuadrics {
 public:
  // Without attributes among the wishes nothing is stored.
  AttributeQuadrics(const CollapseMesh& mesh, const SimplifyConstraints& constraints);

  bool empty() const { return sums_.empty(); }
  // What a collapse of an edge leaves as error, on all of its sides; no area.
  Quadric residual(uint32_t edge) const;
  // To be called before the mesh carries out a collapse.
  void collapse(const Collapse& step);

 private:
  struct Joined {
    uint32_t sectors[2][2];  // on each side: the one at the first vertex, the one at the second
    int count;
  };

  void addTriangle(uint32_t t, const SimplifyConstraints& constraints);
  Joined sectorsAt(uint32_t edge, uint32_t first, uint32_t second) const;
  Quadric residualOf(uint32_t first, uint32_t second) const;
  double* sumsOf(uint32_t sector) { return sums_.data() + size_t{sector} * stride_; }
  const double* sumsOf(uint32_t sector) const { return sums_.data() + size_t{sector} * stride_; }

  const CollapseMesh& mesh_;
  uint32_t dimension_ = 0, stride_ = 0;
  // Per sector: sum over j, f of a g g^T (xx, xy, xz, yy, yz, zz), of a d g, of a d^2; the area; then for
  // each attribute the sums over f of a g and a d.
  std::vector<double> sums_;
};

}  // namespace limber
