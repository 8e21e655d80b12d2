#include "simplify/cost/paper.h"

#include <algorithm>
#include <numeric>

#include "mesh/quality.h"
#include "simplify/cost/changed_triangles.h"

namespace limber {

PaperCost::PaperCost(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
                     const SimplifyOptions& options)
    : CostBase(mesh, options),
      guidance_(guidance),
      strainWeight_(guidance.strain.empty() ? 0 : options.strainWeight),
      curvatureWeight_(guidance.curvature.empty() ? 0 : options.curvatureWeight),
      qualityWeight_(options.qualityWeight),
      guidanceCosts_(mesh.edgeCount(), 0) {
  startGuidance(input);
}

// An input vertex is its own nearest vertex, and its nearest triangle is one of those around it.
void PaperCost::startGuidance(const TriangleMesh& input) {
  if (strainWeight_ != 0) {
    nearestTriangle_ = NearestTriangle(input);
    nearestInputTriangle_.resize(mesh_.vertexCount());
    for (uint32_t v = 0; v < mesh_.vertexCount(); ++v)
      nearestInputTriangle_[v] = nearestTriangle_.findAround(v, mesh_.star(v));
  }
  if (curvatureWeight_ != 0) {
    nearestVertex_ = NearestVertex(input);
    nearestInputVertex_.resize(mesh_.vertexCount());
    std::iota(nearestInputVertex_.begin(), nearestInputVertex_.end(), 0);
  }
}

Vec3 PaperCost::inFile(const Vec3& p) const {
  const auto [x, y, z] = mesh_.inFile(p);
  return {x, y, z};
}

void PaperCost::setBounds(std::span<const uint32_t> edges) {
  finder_.forEach(edges, [&](uint32_t edge, const Optimum& optimum) {
    guidanceCosts_[edge] = static_cast<float>(guidanceCost(edge, optimum.position));
    setCandidate(edge, optimum, (optimum.error + guidanceCosts_[edge]) * keepFactor(edge));
  });
}

double PaperCost::cost(uint32_t edge) const {
  return boundsAreCosts() ? bound(edge) : costAt(edge, optimum(edge));
}

// Eq. 11.
double PaperCost::costAt(uint32_t edge, const Optimum& optimum) const {
  return (optimum.error + guidanceCosts_[edge] +
          qualityWeight_ * meanQualityDeficit(edge, optimum.position)) *
         keepFactor(edge);
}

CostTerms PaperCost::terms(uint32_t edge, const Optimum& optimum) const {
  CostTerms terms;
  terms.keep = keepFactor(edge);
  terms.error = optimum.error;
  if (strainWeight_ != 0) terms.strain = strainWeight_ * strainAt(edge);
  if (curvatureWeight_ != 0) terms.curvature = std::max(guidanceCosts_[edge] - terms.strain, 0.0);
  if (qualityWeight_ != 0) {
    const double rest = optimum.error + guidanceCosts_[edge];
    terms.quality = std::max(costAt(edge, optimum) / terms.keep - rest, 0.0);
  }
  return terms;
}

// alpha E_strain + beta E_curv (Eq. 8).
double PaperCost::guidanceCost(uint32_t edge, const Vec3& target) const {
  double cost = 0;
  if (strainWeight_ != 0) cost += strainWeight_ * strainAt(edge);
  if (curvatureWeight_ != 0) cost += curvatureWeight_ * guidance_.curvature[nearestInputVertex(target, edge)];
  return cost;
}

double PaperCost::strainAt(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  return std::max(guidance_.strain[nearestInputTriangle_[a]], guidance_.strain[nearestInputTriangle_[b]]);
}

// The input vertex nearest to the target of an edge.
uint32_t PaperCost::nearestInputVertex(const Vec3& target, uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const double toA = squaredLength(target - mesh_.position(a)),
               toB = squaredLength(target - mesh_.position(b));
  const uint32_t guess = nearestInputVertex_[toA <= toB ? a : b];
  return toA == 0 || toB == 0 ? guess : nearestVertex_.find(inFile(target), guess);
}

// E_tri_q (Eq. 10) after the collapse; 0 if it changes no triangle.
double PaperCost::meanQualityDeficit(uint32_t edge, const Vec3& target) const {
  double sum = 0;
  int count = 0;
  forEachChangedTriangle(mesh_, edge, [&](const Vec3& q, const Vec3& r) {
    sum += 1 - triangleQuality(target, q, r);
    ++count;
  });
  return count > 0 ? sum / count : 0;
}

void PaperCost::collapse(const Collapse& step) {
  CostBase::collapse(step);
  if (curvatureWeight_ != 0) nearestInputVertex_[step.kept] = nearestInputVertex(step.target, step.edge);
  if (nearestInputTriangle_.empty() || step.target == mesh_.position(step.kept)) return;
  uint32_t& nearest = nearestInputTriangle_[step.kept];
  nearest = step.target == mesh_.position(step.removed) ? nearestInputTriangle_[step.removed]
                                                        : nearestTriangle_.find(inFile(step.target), nearest);
}

}  // namespace limber
