#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "query/nearest.h"
#include "simplify/attribute_quadrics.h"
#include "simplify/collapse_mesh.h"
#include "simplify/quadric.h"
#include "simplify/simplify.h"

namespace limber {

// Where an edge would collapse to, and the geometric error of that.
struct Placement {
  Vec3 target;       // as it will be recorded: a float32 position in the file
  double error = 0;  // E_QEM, see CostModel
};

// What a cost is made of: cost = (error + size + strain + curvature + quality) * keep, in squared lengths
// where the diagonal is 300, but for the terms of `paper` that carry no length.
struct CostTerms {
  double error = 0;      // E_QEM with its weight, attributes included
  double size = 0;       // of the squared length of the edge
  double strain = 0;     // limber: what strain adds to the size
  double curvature = 0;  // paper
  double quality = 0;    // limber: what the worst triangle adds to all of the above
  double keep = 1;       // factor of the keep weights

  double total() const { return (error + size + strain + curvature + quality) * keep; }
};

// Prices collapses: E_QEM for `qem`, Eq. 11 for `paper`.
//
// E_QEM is Eq. 7 with area-weighted plane quadrics, normalised (Garland 1999): each vertex starts with the
// planes of its triangles, weighted by their areas, and with the areas' sum; both add up in a collapse, and
// the error is the sum of squares over the area: a mean squared distance. A border or other line (see
// SimplifyConstraints) adds the planes through it that stand on its triangles to both of its ends, weighted
// by kBorderWeight times its squared length but not counted as area. Lengths are measured where the diagonal
// of the bounding box is 300. Deviation: Eq. 11 adds terms without a length to a squared length, so its
// result depends on the file's units; the frame fixes them. Where planes leave the order open (flat faces,
// straight creases), E_QEM would be rounding noise; a term of kShortness times the squared length of the
// edge, far below what float32 coordinates show, takes shorter edges first there; for `qem` the size weight
// adds to it.
//
// limber: (3 E_QEM + s (1 + w sigma) L^2) (1 + g (1 / q - 1) (1 + p)), with L the edge's length, sigma the
// larger strain rank at its ends, q the worst quality (Eq. 9) among the changed triangles after the collapse,
// and s, w, g the weights of size, strain and quality. p is (0.15 / q)^4, at most 3, where q is below 0.3 and
// the triangles around both ends are all better than 0.24, else 0: no sliver where there is none yet. All
// terms are squared lengths or pure numbers, so units do not matter.
class CostModel {
 public:
  // Keeps references to all of them. Works on many edges: reports to `job`.
  CostModel(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
            const SimplifyOptions& options);

  // The place of least error for an edge, or its fixed end where it has one, so that lines keep their shape;
  // where the optimum lies far off, the best of the middle and the ends.
  Placement place(uint32_t edge) const;

  // Costs are found late: each edge has a bound first, which its cost never falls below while its own ends
  // stay as they are. Sets the bounds of edges; may be called for different edges at the same time.
  void setBounds(std::span<const uint32_t> edges);
  float bound(uint32_t edge) const { return plans_[edge].bound; }
  // Whether the bounds of `setBounds` are the costs themselves.
  bool boundsAreCosts() const { return method_ != Method::Limber && qualityWeight_ == 0; }
  // Whether edges have to be queued again by their bounds when their ends or the triangles around these
  // change. All others are left where they wait, or where `guess` puts them, and are priced anew when they
  // come up: most have become dearer, or are gone by then. Only an edge that has become cheaper comes late,
  // which does not show in the distance of the result (it is 0.5 % less for qem on 18 meshes at 25 %).
  bool followsNeighbourhood() const { return method_ == Method::Paper && qualityWeight_ > 0; }
  // Of two costs whose ratio is below this either may go first: for limber kTolerance, which saves half of
  // its time.
  double tolerance() const { return method_ == Method::Limber ? kTolerance : 1; }
  // What to expect of the cost of an edge, which has been `cost`, after its own ends have changed: the same,
  // but for limber less where the edge is shorter now, and no less than its size.
  double guess(uint32_t edge, double cost);
  // Better bounds, which take into account where edges would collapse to. They hold as long as the others.
  void raiseBounds(std::span<const uint32_t> edges);
  // Of an edge with a raised bound, or with one that is the cost.
  double cost(uint32_t edge) const;
  // Where `place` has put such an edge.
  Vec3 target(uint32_t edge) const {
    const auto [x, y, z] = plans_[edge].target;
    return mesh_.fromFile({x, y, z});
  }

  // The parts of the same cost.
  CostTerms terms(uint32_t edge, const Placement& placement) const;

  // To be called before the mesh carries out a collapse; updates what is known of the kept vertex.
  void collapse(const Collapse& step);

 private:
  static constexpr double kTolerance = 1.08;

  void startGuidance(const TriangleMesh& input);
  // What the place of an edge's collapse is found from.
  struct Around {
    uint32_t edge;
    bool isFree;  // neither end is fixed
    Quadric sum;
    Vec3 p, q;
  };
  std::array<Placement, 2> placeTwo(const Around& e, const Around& f) const;
  template <class Visit>
  void placeAll(std::span<const uint32_t> edges, const Visit& visit) const;
  template <class Real>
  struct Optimum;
  template <class Real>
  Optimum<Real> findOptimum(const QuadricOf<Real>& sum, const Point<Real>& p, const Point<Real>& q) const;
  // What is known of an edge that waits.
  struct Plan {
    std::array<float, 3> target;  // in the file
    float bound;
  };
  double costOf(uint32_t edge, const Placement& placement) const;
  Quadric sumOf(uint32_t edge) const;
  double keepFactor(uint32_t edge) const;
  double guidanceCost(uint32_t edge, const Vec3& target) const;
  double sizeCost(uint32_t edge) const;
  void averageStrain();
  double strainAt(uint32_t edge) const;
  double qualityFactor(uint32_t edge, const Vec3& target) const;
  double meanBadness(uint32_t edge, const Vec3& target) const;
  double worstQuality(uint32_t edge, const Vec3& target) const;
  double worstQualityAround(uint32_t edge) const;  // before the collapse
  double sliverPrice(uint32_t edge, double quality) const;
  template <class Visit>
  void forEachChanged(uint32_t edge, const Visit& visit) const;
  uint32_t nearestVertex(const Vec3& target, uint32_t edge) const;
  Vec3 inFile(const Vec3& p) const;

  const CollapseMesh& mesh_;
  double lengthScale_;  // squared lengths of the mesh -> of the frame whose diagonal is 300
  Method method_;
  double shortness_;   // of the squared length of an edge within the error
  double sizeWeight_;  // of the squared length of an edge
  AttributeQuadrics attributes_;
  std::vector<float> keep_;  // [v]: the largest keep weight of those that have become v; or empty

  double strainWeight_ = 0, curvatureWeight_ = 0, qualityWeight_ = 0;
  Guidance guidance_;
  NearestTriangle nearestTriangle_;
  NearestVertex nearestVertex_;
  std::vector<float> strainOfVertex_;       // limber: mean over the area that has become a vertex
  std::vector<uint32_t> triangleOfVertex_;  // paper: the input triangle that is nearest to a vertex
  std::vector<uint32_t> vertexOfVertex_;    // the input vertex that is nearest to a vertex
  // Per edge: guidanceCost for its last `setBounds`; limber: the sizeCost that belongs to its last cost.
  std::vector<float> guidanceCosts_;
  std::vector<Plan> plans_;  // per edge
};

}  // namespace limber
