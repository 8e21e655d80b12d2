#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "simplify/collapse_mesh.h"
#include "simplify/cost/attribute_quadrics.h"
#include "simplify/quadric.h"

namespace limber {

// The position to which an edge collapses, and the geometric error there.
struct Optimum {
  Vec3 position;     // as recorded in the history: a float32 point of the file
  double error = 0;  // E_QEM, in squared lengths of the frame whose diagonal is 300
};

// Finds the optimum of edges, and E_QEM there.
//
// E_QEM is Eq. 7 with area-weighted plane quadrics, normalised (Garland 1999): each vertex starts with the
// planes of its triangles, weighted by their areas, and with the sum of these areas; a collapse adds both.
// The error is the weighted sum of squares over the area: a mean squared distance. Every feature edge (see
// SimplifyConstraints) adds planes to both of its ends: those through the edge perpendicular to its
// triangles, weighted by kFeatureWeight times the squared length of the edge (a seam: by the area of the
// triangle times its texture weight) and not counted as area.
// Attributes add their residual, see AttributeQuadrics.
//
// Where planes do not determine the order of collapses (flat faces, straight creases), E_QEM would be
// rounding noise. There a term of kTieBreak times the squared length of the edge, far below the resolution of
// float32 coordinates, collapses shorter edges first.
//
// Deviation: Eq. 11 adds terms without a length to a squared length, so its result would depend on the units
// of the file. Lengths are therefore measured where the diagonal of the bounding box is 300.
class OptimumFinder {
 public:
  // `lengthWeight` is the weight of the squared length of an edge in its error, in addition to the term
  // above. Keeps a reference to `mesh`.
  OptimumFinder(const CollapseMesh& mesh, const SimplifyConstraints& constraints, double lengthWeight = 0);

  // The optimum of an edge: the position of least error, or the fixed end if the edge has one, so that
  // feature edges keep their shape. If the position of least error lies too far from the edge, the best of
  // its midpoint and both ends.
  Optimum find(uint32_t edge) const;

  // Calls visit(edge, find(edge)) for each edge in order; bit-identical to single calls and much faster.
  template <class Visit>
  void forEach(std::span<const uint32_t> edges, const Visit& visit) const;

  // The squared length of an edge in the frame.
  double squaredLengthOf(uint32_t edge) const;
  // The factor from squared lengths of the mesh to those of the frame.
  double lengthScale() const { return lengthScale_; }
  // The part of the error of an edge that comes from its length, without the tie-breaking term.
  double sizeError(uint32_t edge) const { return (lengthWeight_ - kTieBreak) * squaredLengthOf(edge); }

  // Must be called before the mesh carries out a collapse.
  void collapse(const Collapse& step) { attributes_.collapse(step); }

 private:
  // Weight of the squared length of an edge.
  static constexpr double kTieBreak = 1e-9;
  static constexpr size_t kTogether = 16;  // edges whose memory is read before any of them is worked on

  // The data from which the optimum of an edge is found.
  struct Input {
    uint32_t edge;
    bool isFree;  // neither end is fixed
    Quadric sum;
    Vec3 p, q;  // the ends
  };
  template <class Real>
  struct Minimum;

  Input inputOf(uint32_t edge) const {
    const auto [a, b] = mesh_.edge(edge);
    return {edge, mesh_.fixedEnd(edge) == kNone, sumOf(edge), mesh_.position(a), mesh_.position(b)};
  }
  std::array<Optimum, 2> findTwo(const Input& e, const Input& f) const;
  // The sum of the quadrics of both ends, including those of their attributes.
  Quadric sumOf(uint32_t edge) const {
    const auto [a, b] = mesh_.edge(edge);
    const Quadric planes = mesh_.quadric(a) + mesh_.quadric(b);
    return attributes_.empty() ? planes : planes + attributes_.residual(edge);
  }
  template <class Real>
  Minimum<Real> minimumOf(const QuadricOf<Real>& sum, const Point<Real>& p, const Point<Real>& q) const;

  const CollapseMesh& mesh_;
  double lengthScale_;
  double lengthWeight_;  // of the squared length of an edge within the error
  AttributeQuadrics attributes_;
};

// Reads the data of all edges of a batch before it processes any, so that the memory latencies overlap.
template <class Visit>
void OptimumFinder::forEach(std::span<const uint32_t> edges, const Visit& visit) const {
  std::array<Input, kTogether> inputs;
  for (size_t begin = 0; begin < edges.size(); begin += kTogether) {
    const size_t count = std::min(edges.size() - begin, kTogether);
    for (size_t i = 0; i < count; ++i) inputs[i] = inputOf(edges[begin + i]);
    for (size_t i = 0; i + 1 < count; i += 2) {
      const auto [first, second] = findTwo(inputs[i], inputs[i + 1]);
      visit(inputs[i].edge, first);
      visit(inputs[i + 1].edge, second);
    }
    if (count % 2 != 0) visit(edges[begin + count - 1], find(edges[begin + count - 1]));
  }
}

}  // namespace limber
