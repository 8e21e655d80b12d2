#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simplify/collapse_mesh.h"
#include "simplify/kd_tree.h"
#include "simplify/quadric.h"
#include "simplify/simplify.h"

namespace limber {

// Where an edge would collapse to, and the geometric error of that.
struct Placement {
  Vec3 target;       // as it will be recorded: a float32 position in the file
  double error = 0;  // E_QEM, see CostModel
};

// Prices collapses: E_QEM for `qem`, Eq. 11 for `paper`.
//
// E_QEM is Eq. 7 with area-weighted plane quadrics, normalised (Garland 1999): each vertex starts with the
// planes of its triangles, weighted by their areas, and with the areas' sum; both add up in a collapse, and
// the error is the sum of squares over the area: a mean squared distance. A border edge adds the plane
// through it that stands on its triangle to both of its ends, weighted by kBorderWeight times its squared
// length but not counted as area. Lengths are measured where the diagonal of the bounding box is 300.
// Deviation: Eq. 11 adds terms without a length to a squared length, so its result depends on the file's
// units; the frame fixes them.
// Where planes leave the order open (flat faces, straight creases), E_QEM would be rounding noise; a term of
// kShortness times the squared length of the edge, far below what float32 coordinates show, takes shorter
// edges first there; for `qem` the size weight adds to it.
//
// limber: (3 E_QEM + s (1 + w sigma) L^2) (1 + g (1 / q - 1)), with L the edge's length, sigma the larger
// strain rank at its ends, q the worst quality (Eq. 9) among the changed triangles after the collapse, and s,
// w, g the weights of size, strain and quality. All terms are squared lengths or pure numbers, so units do
// not matter.
class CostModel {
 public:
  // Keeps references to all of them. Works on many edges: reports to `job`.
  CostModel(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
            const SimplifyOptions& options);

  // The place of least error for an edge, on the border's end where just one end is on a border, so that
  // borders keep their shape; where the optimum lies far off, the best of the middle and the ends.
  Placement place(uint32_t edge) const;

  // costs[i]: the cost of edges[i]. May be called for different edges at the same time.
  void evaluate(std::span<const uint32_t> edges, std::span<double> costs);

  // Whether costs depend on the triangles around an edge's ends, not on the ends alone; then `revalue` gives
  // the new costs of edges whose own ends have stayed as they were since their last `evaluate`.
  bool dependsOnSurroundings() const { return qualityWeight_ > 0; }
  void revalue(std::span<const uint32_t> edges, std::span<double> costs) const;

  // To be called before the mesh carries out a collapse; updates what is known of the kept vertex.
  void collapse(const Collapse& step);

 private:
  void collectQuadrics();
  void startGuidance(const TriangleMesh& input);
  std::array<Placement, 2> placeTwo(uint32_t e, uint32_t f) const;
  template <class Visit>
  void placeAll(std::span<const uint32_t> edges, const Visit& visit) const;
  template <class Real>
  struct Optimum;
  template <class Real>
  Optimum<Real> findOptimum(const QuadricOf<Real>& sum, const Point<Real>& p, const Point<Real>& q) const;
  int endsOnBorder(uint32_t edge) const;
  double total(uint32_t edge, const Placement& placement) const;
  double guidanceCost(uint32_t edge, const Vec3& target) const;
  double meanBadness(uint32_t edge, const Vec3& target) const;
  double worstQuality(uint32_t edge, const Vec3& target) const;
  template <class Visit>
  void forEachChanged(uint32_t edge, const Visit& visit) const;
  uint32_t nearestVertex(const Vec3& target, uint32_t edge) const;
  Vec3 inFile(const Vec3& p) const;

  const CollapseMesh& mesh_;
  double lengthScale_;  // squared lengths of the mesh -> of the frame whose diagonal is 300
  Method method_;
  double shortness_;   // of the squared length of an edge within the error
  double sizeWeight_;  // of the squared length of an edge
  std::vector<Quadric> quadrics_;

  double strainWeight_ = 0, curvatureWeight_ = 0, qualityWeight_ = 0;
  Guidance guidance_;
  NearestTriangle nearestTriangle_;
  NearestVertex nearestVertex_;
  std::vector<uint32_t> triangleOfVertex_;  // the input triangle that is nearest to a vertex
  std::vector<uint32_t> vertexOfVertex_;    // the input vertex that is nearest to a vertex
  std::vector<float> guidanceCosts_;        // per edge: alpha E_strain + beta E_curv of its last `evaluate`
};

}  // namespace limber
