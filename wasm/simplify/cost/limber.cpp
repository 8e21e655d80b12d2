#include "simplify/cost/limber.h"

#include <algorithm>
#include <cmath>

#include "mesh/quality.h"
#include "simplify/cost/changed_triangles.h"

namespace limber {
namespace {

// The weight of E_QEM relative to the size cost: larger values approximate the surface more closely, smaller
// ones make edge lengths more uniform and put more edges where strain is high.
constexpr double kErrorWeight = 3;
// Worse qualities cost no more than this one, so that collapses between needles have finite, ordered costs.
constexpr double kMinQuality = 1e-6;
// The sliver price is (kSliverQuality / q)^4: 1 at an angle of about five degrees, and steep, so that good
// triangles pay almost nothing. A larger quality or a lower power would move collapses away from where they
// cost the least distance.
constexpr double kSliverQuality = 0.15;
// Triangles of a better quality, in multiples of kSliverQuality, have no sliver price at all: it would be
// below 1 / 16, and this avoids testing the triangles around.
constexpr double kSliverRange = 2;
// The price only applies if all triangles around are better than this (eight degrees between equal sides).
// Elsewhere slivers cannot be avoided, and trying to would only cost distance.
constexpr double kNoSliver = 0.24;
// A higher bound would prevent more slivers, but edges whose cost can fall far come up late, see CostPolicy.
constexpr double kLargestSliverPrice = 3;

double fourthPower(double x) {
  const double square = x * x;
  return square * square;
}

}  // namespace

LimberCost::LimberCost(const TriangleMesh&, const CollapseMesh& mesh, const Guidance& guidance,
                       const SimplifyOptions& options)
    : CostBase(mesh, options),
      strainWeight_(guidance.strain.empty() ? 0 : options.strainWeight),
      qualityWeight_(options.qualityWeight),
      sizeWeight_(options.sizeWeight),
      sizeCosts_(mesh.edgeCount(), 0) {
  if (strainWeight_ != 0) averageStrain(guidance.strain);
}

void LimberCost::averageStrain(std::span<const float> strain) {
  strainOfVertex_.assign(mesh_.vertexCount(), 0);
  for (uint32_t v = 0; v < mesh_.vertexCount(); ++v) {
    double sum = 0, area = 0;
    for (const Corner corner : mesh_.star(v)) {
      const auto& [a, b, c] = mesh_.face(corner.triangle()).vertices;
      const double twiceArea =
          length(cross(mesh_.position(b) - mesh_.position(a), mesh_.position(c) - mesh_.position(a)));
      sum += twiceArea * strain[corner.triangle()];
      area += twiceArea;
    }
    if (area > 0) strainOfVertex_[v] = static_cast<float>(sum / area);
  }
}

void LimberCost::setBounds(std::span<const uint32_t> edges) {
  for (const uint32_t edge : edges) {
    sizeCosts_[edge] = static_cast<float>(sizeCost(edge));
    setBound(edge, sizeCosts_[edge] * keepFactor(edge));
  }
}

void LimberCost::raiseBounds(std::span<const uint32_t> edges) {
  finder_.forEach(edges, [&](uint32_t edge, const Optimum& optimum) {
    sizeCosts_[edge] = static_cast<float>(sizeCost(edge));
    setCandidate(edge, optimum, (kErrorWeight * optimum.error + sizeCosts_[edge]) * keepFactor(edge));
  });
}

double LimberCost::expectedCost(uint32_t edge, double cost) {
  const auto size = static_cast<float>(sizeCost(edge));
  float& before = sizeCosts_[edge];
  if (size < before) {
    cost *= size / before;
    before = size;
  }
  return std::max(cost, size * keepFactor(edge));
}

CostTerms LimberCost::terms(uint32_t edge, const Optimum& optimum) const {
  CostTerms terms;
  terms.keep = keepFactor(edge);
  terms.error = kErrorWeight * optimum.error;
  terms.size = sizeWeight_ * finder_.squaredLengthOf(edge);
  if (strainWeight_ != 0) terms.strain = terms.size * (strainWeight_ * strainAt(edge));
  if (qualityWeight_ != 0) {
    const double cost = (terms.error + sizeCost(edge)) * qualityFactor(edge, optimum.position) * terms.keep;
    const double rest = terms.error + terms.size + terms.strain;
    terms.quality = std::max(cost / terms.keep - rest, 0.0);
  }
  return terms;
}

// The cost of the length of an edge, higher where strain is high.
double LimberCost::sizeCost(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const double strain = strainWeight_ != 0 ? strainWeight_ * strainAt(edge) : 0;
  return finder_.lengthScale() * sizeWeight_ * (1 + strain) *
         squaredLength(mesh_.position(b) - mesh_.position(a));
}

double LimberCost::strainAt(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  return std::max(strainOfVertex_[a], strainOfVertex_[b]);
}

// The factor of the worst triangle on a cost.
double LimberCost::qualityFactor(uint32_t edge, const Vec3& target) const {
  const double quality = std::max(worstQualityAfter(edge, target), kMinQuality);
  return 1 + qualityWeight_ * (1 / quality - 1) * (1 + sliverPrice(edge, quality));
}

double LimberCost::sliverPrice(uint32_t edge, double quality) const {
  if (quality > kSliverRange * kSliverQuality || !(worstQualityBefore(edge) > kNoSliver)) return 0;
  return std::min(fourthPower(kSliverQuality / quality), kLargestSliverPrice);
}

// Among the triangles that the collapse changes.
double LimberCost::worstQualityAfter(uint32_t edge, const Vec3& target) const {
  const Point<RealPair> p = asPair(target, target);
  RealPair worst{1, 1};
  const Vec3 *firstQ = nullptr, *firstR = nullptr;  // a triangle that waits for a second one
  const auto takePair = [&](const Vec3& q, const Vec3& r) {
    const RealPair quality = squaredTriangleQuality(p, asPair(*firstQ, q), asPair(*firstR, r));
    worst = quality < worst ? quality : worst;
    firstQ = nullptr;
  };
  forEachChangedTriangle(mesh_, edge, [&](const Vec3& q, const Vec3& r) {
    if (firstQ != nullptr) return takePair(q, r);
    firstQ = &q;
    firstR = &r;
  });
  if (firstQ != nullptr) takePair(*firstQ, *firstR);
  return std::sqrt(std::min(worst[0], worst[1]));
}

// Among all triangles around both ends.
double LimberCost::worstQualityBefore(uint32_t edge) const {
  double worst = 1;
  const auto [first, second] = mesh_.edge(edge);
  for (const uint32_t v : {first, second})
    for (const Corner corner : mesh_.star(v)) {
      const auto& [a, b, c] = mesh_.face(corner.triangle()).vertices;
      worst = std::min(worst, triangleQuality(mesh_.position(a), mesh_.position(b), mesh_.position(c)));
    }
  return worst;
}

void LimberCost::collapse(const Collapse& step) {
  CostBase::collapse(step);
  if (strainOfVertex_.empty()) return;
  const double kept = mesh_.quadric(step.kept).area, removed = mesh_.quadric(step.removed).area;
  float& strain = strainOfVertex_[step.kept];
  if (kept + removed > 0)
    strain = static_cast<float>((kept * strain + removed * strainOfVertex_[step.removed]) / (kept + removed));
}

}  // namespace limber
