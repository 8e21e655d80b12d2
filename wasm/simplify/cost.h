#pragma once

#include <cstdint>
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
// edges first there; the size weight adds to it.
class CostModel {
 public:
  // Keeps references to all of them. Works on many edges: reports to `job`.
  CostModel(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
            const SimplifyOptions& options);

  // The place of least error for an edge, on the border's end where just one end is on a border, so that
  // borders keep their shape; where the optimum lies far off, the best of the middle and the ends.
  Placement place(uint32_t edge) const;

  // The cost of an edge. May be called for different edges at the same time.
  double evaluate(uint32_t edge);

  // Whether costs depend on the triangles around an edge's ends, not on the ends alone; then `revalue` gives
  // the new cost of an edge whose own ends have stayed as they were since its last `evaluate`.
  bool dependsOnSurroundings() const { return qualityWeight_ > 0; }
  double revalue(uint32_t edge) const;

  // To be called before the mesh carries out a collapse; updates what is known of the kept vertex.
  void collapse(const Collapse& step);

 private:
  void collectQuadrics();
  void startGuidance(const TriangleMesh& input);
  double guidanceCost(uint32_t edge, const Vec3& target) const;
  double meanBadness(uint32_t edge, const Vec3& target) const;
  Vec3 inFile(const Vec3& p) const;

  const CollapseMesh& mesh_;
  double lengthScale_;  // squared lengths of the mesh -> of the frame whose diagonal is 300
  double sizeWeight_;   // of the squared length of an edge
  std::vector<Quadric> quadrics_;

  double strainWeight_ = 0, curvatureWeight_ = 0, qualityWeight_ = 0;
  Guidance guidance_;
  NearestTriangle nearestTriangle_;
  NearestVertex nearestVertex_;
  std::vector<float> strain_;         // per vertex: at the nearest input triangle
  std::vector<float> curvature_;      // per vertex: at the nearest input vertex
  std::vector<float> guidanceCosts_;  // per edge: alpha E_strain + beta E_curv of its last `evaluate`
};

}  // namespace limber
