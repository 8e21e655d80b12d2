#include "simplify/cost.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "mesh/quality.h"

namespace limber {
namespace {

constexpr double kFrameDiagonal = 300;
constexpr double kShortness = 1e-9;
constexpr double kWorstQuality = 1e-6;  // keeps the price of a needle finite
// Qualities: a triangle is a sliver from the one down (an angle of five degrees or so), and there is none
// where all are above the other (eight degrees between equal sides).
constexpr double kSliver = 0.15, kNoSliver = 0.24;
constexpr double kMostSliverPrice = 3;  // costs that may fall far come late: see followsNeighbourhood
// How far from the middle of an edge its target may lie, in lengths of the edge.
constexpr double kReach = 2;
constexpr size_t kPlacedTogether = 16;

}  // namespace

CostModel::CostModel(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
                     const SimplifyOptions& options)
    : mesh_(mesh),
      lengthScale_(kFrameDiagonal / mesh.diagonal()),
      method_(options.method),
      shortness_(kShortness + (options.method == Method::Qem ? options.sizeWeight : 0)),
      sizeWeight_(options.sizeWeight),
      attributes_(mesh, options.constraints),
      keep_(options.constraints.keep.begin(), options.constraints.keep.end()),
      guidance_(guidance) {
  lengthScale_ *= lengthScale_;
  plans_.resize(mesh.edgeCount());
  if (options.method == Method::Qem) return;
  strainWeight_ = guidance.strain.empty() ? 0 : options.strainWeight;
  curvatureWeight_ =
      guidance.curvature.empty() || options.method == Method::Limber ? 0 : options.curvatureWeight;
  qualityWeight_ = options.qualityWeight;
  startGuidance(input);
}

// An input vertex is its own nearest vertex, and its nearest triangle is one of those around it.
void CostModel::startGuidance(const TriangleMesh& input) {
  if (strainWeight_ != 0 && method_ == Method::Limber) {
    averageStrain();
  } else if (strainWeight_ != 0) {
    nearestTriangle_ = NearestTriangle(input);
    triangleOfVertex_.resize(mesh_.vertexCount());
    for (uint32_t v = 0; v < mesh_.vertexCount(); ++v)
      triangleOfVertex_[v] = nearestTriangle_.findAround(v, mesh_.star(v));
  }
  if (curvatureWeight_ != 0) {
    nearestVertex_ = NearestVertex(input);
    vertexOfVertex_.resize(mesh_.vertexCount());
    std::iota(vertexOfVertex_.begin(), vertexOfVertex_.end(), 0);
  }
  guidanceCosts_.assign(mesh_.edgeCount(), 0);
}

void CostModel::averageStrain() {
  strainOfVertex_.assign(mesh_.vertexCount(), 0);
  for (uint32_t v = 0; v < mesh_.vertexCount(); ++v) {
    double sum = 0, area = 0;
    for (const Corner corner : mesh_.star(v)) {
      const auto& [a, b, c] = mesh_.face(corner.triangle()).vertices;
      const double part =
          length(cross(mesh_.position(b) - mesh_.position(a), mesh_.position(c) - mesh_.position(a)));
      sum += part * guidance_.strain[corner.triangle()];
      area += part;
    }
    if (area > 0) strainOfVertex_[v] = static_cast<float>(sum / area);
  }
}

Vec3 CostModel::inFile(const Vec3& p) const {
  const auto [x, y, z] = mesh_.inFile(p);
  return {x, y, z};
}

// The optimum of one edge or two, rounded as it will be stored.
template <class Real>
struct CostModel::Optimum {
  Point<Real> target;
  Real error;      // E_QEM
  Real overreach;  // positive where the target lies too far off
};

template <class Real>
CostModel::Optimum<Real> CostModel::findOptimum(const QuadricOf<Real>& sum, const Point<Real>& p,
                                                const Point<Real>& q) const {
  const Point<Real> edge = q - p, middle = (p + q) * 0.5;
  const Point<Real> optimum = minimize(sum, middle), way = optimum - middle;
  const Point<Real> target = mesh_.rounded(optimum);
  const Real square = dot(edge, edge);
  return {target, lengthScale_ * (normalizedError(sum, target) + shortness_ * square),
          dot(way, way) - kReach * kReach * square};
}

// What the planes and attributes around both ends make of the place of an edge's collapse.
Quadric CostModel::sumOf(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Quadric planes = mesh_.quadric(a) + mesh_.quadric(b);
  return attributes_.empty() ? planes : planes + attributes_.residual(edge);
}

Placement CostModel::place(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Vec3 &p = mesh_.position(a), &q = mesh_.position(b);
  const Quadric sum = sumOf(edge);
  const auto at = [&](const Vec3& target) {
    const double error = normalizedError(sum, asPoint(target)) + shortness_ * squaredLength(q - p);
    return Placement{target, lengthScale_ * error};
  };
  if (const uint32_t fixed = mesh_.fixedEnd(edge); fixed != kNone)
    return at(mesh_.stored(mesh_.position(fixed)));
  const auto optimum = findOptimum(sum, asPoint(p), asPoint(q));
  if (!(optimum.overreach > 0)) return {asVec3(optimum.target), optimum.error};
  const Vec3 middle = asVec3(mesh_.rounded(asPoint((p + q) * 0.5)));
  const Placement choices[] = {at(middle), at(mesh_.stored(p)), at(mesh_.stored(q))};
  return *std::ranges::min_element(choices, {}, &Placement::error);
}

// The same as `place` for each, bit by bit, in less time.
std::array<Placement, 2> CostModel::placeTwo(const Around& e, const Around& f) const {
  if (!e.isFree || !f.isFree) return {place(e.edge), place(f.edge)};
  const auto optimum = findOptimum(asPair(e.sum, f.sum), asPair(e.p, f.p), asPair(e.q, f.q));
  const auto placement = [&](uint32_t edge, int i) {
    return optimum.overreach[i] > 0 ? place(edge) : Placement{lane(optimum.target, i), optimum.error[i]};
  };
  return {placement(e.edge, 0), placement(f.edge, 1)};
}

// Calls visit(edge, place(edge)) for every edge. Reads what some edges need before it works on any: so the
// machine waits for all of these places of memory at once.
template <class Visit>
void CostModel::placeAll(std::span<const uint32_t> edges, const Visit& visit) const {
  std::array<Around, kPlacedTogether> around;
  for (size_t begin = 0; begin < edges.size(); begin += kPlacedTogether) {
    const size_t count = std::min(edges.size() - begin, kPlacedTogether);
    for (size_t i = 0; i < count; ++i) {
      const uint32_t edge = edges[begin + i];
      const auto [a, b] = mesh_.edge(edge);
      around[i] = {edge, mesh_.fixedEnd(edge) == kNone, sumOf(edge), mesh_.position(a), mesh_.position(b)};
    }
    for (size_t i = 0; i + 1 < count; i += 2) {
      const auto [first, second] = placeTwo(around[i], around[i + 1]);
      visit(around[i].edge, first);
      visit(around[i + 1].edge, second);
    }
    if (count % 2 != 0) visit(around[count - 1].edge, place(around[count - 1].edge));
  }
}

void CostModel::setBounds(std::span<const uint32_t> edges) {
  if (method_ == Method::Limber) {
    for (const uint32_t edge : edges) {
      guidanceCosts_[edge] = static_cast<float>(sizeCost(edge));
      plans_[edge].bound = static_cast<float>(guidanceCosts_[edge] * keepFactor(edge));
    }
    return;
  }
  placeAll(edges, [&](uint32_t edge, const Placement& placement) {
    double bound = placement.error;
    if (!guidanceCosts_.empty()) {
      guidanceCosts_[edge] = static_cast<float>(guidanceCost(edge, placement.target));
      bound += guidanceCosts_[edge];
    }
    plans_[edge] = {mesh_.inFile(placement.target), static_cast<float>(bound * keepFactor(edge))};
  });
}

void CostModel::raiseBounds(std::span<const uint32_t> edges) {
  if (method_ != Method::Limber) return setBounds(edges);
  placeAll(edges, [&](uint32_t edge, const Placement& placement) {
    guidanceCosts_[edge] = static_cast<float>(sizeCost(edge));
    const double bound = (3 * placement.error + guidanceCosts_[edge]) * keepFactor(edge);
    plans_[edge] = {mesh_.inFile(placement.target), static_cast<float>(bound)};
  });
}

double CostModel::guess(uint32_t edge, double cost) {
  if (method_ != Method::Limber) return cost;
  const auto size = static_cast<float>(sizeCost(edge));
  float& before = guidanceCosts_[edge];
  if (size < before) {
    cost *= size / before;
    before = size;
  }
  return std::max(cost, size * keepFactor(edge));
}

double CostModel::cost(uint32_t edge) const {
  if (boundsAreCosts()) return bound(edge);
  if (method_ != Method::Limber) return costOf(edge, place(edge));
  return bound(edge) * qualityFactor(edge, target(edge));
}

// Eq. 11, limber's product, or E_QEM alone.
double CostModel::costOf(uint32_t edge, const Placement& placement) const {
  const double factor = keepFactor(edge);
  if (method_ == Method::Limber)
    return (3 * placement.error + sizeCost(edge)) * qualityFactor(edge, placement.target) * factor;
  if (guidanceCosts_.empty()) return placement.error * factor;
  return (placement.error + guidanceCosts_[edge] + qualityWeight_ * meanBadness(edge, placement.target)) *
         factor;
}

// limber's price of the worst triangle.
double CostModel::qualityFactor(uint32_t edge, const Vec3& target) const {
  const double quality = std::max(worstQuality(edge, target), kWorstQuality);
  return 1 + qualityWeight_ * (1 / quality - 1) * (1 + sliverPrice(edge, quality));
}

double CostModel::sliverPrice(uint32_t edge, double quality) const {
  if (quality > 2 * kSliver || !(worstQualityAround(edge) > kNoSliver)) return 0;
  const double square = (kSliver / quality) * (kSliver / quality);
  return std::min(square * square, kMostSliverPrice);
}

CostTerms CostModel::terms(uint32_t edge, const Placement& placement) const {
  const auto [a, b] = mesh_.edge(edge);
  const double square = lengthScale_ * squaredLength(mesh_.position(b) - mesh_.position(a));
  CostTerms terms;
  terms.keep = keepFactor(edge);
  const double strain = strainWeight_ != 0 ? strainWeight_ * strainAt(edge) : 0;
  if (method_ == Method::Limber) {
    terms.error = 3 * placement.error;
    terms.size = sizeWeight_ * square;
    terms.strain = terms.size * strain;
  } else {
    terms.size = (shortness_ - kShortness) * square;
    terms.error = placement.error - terms.size;
    terms.strain = strain;
    if (curvatureWeight_ != 0) terms.curvature = std::max(guidanceCosts_[edge] - strain, 0.0);
  }
  if (qualityWeight_ != 0) {
    const double rest = method_ == Method::Limber ? terms.error + terms.size + terms.strain
                                                  : placement.error + guidanceCosts_[edge];
    terms.quality = std::max(costOf(edge, placement) / terms.keep - rest, 0.0);
  }
  return terms;
}

double CostModel::keepFactor(uint32_t edge) const {
  if (keep_.empty()) return 1;
  const auto [a, b] = mesh_.edge(edge);
  return 1 + SimplifyConstraints::kKeepFactor * std::max(keep_[a], keep_[b]);
}

// alpha E_strain + beta E_curv (Eq. 8).
double CostModel::guidanceCost(uint32_t edge, const Vec3& target) const {
  double cost = 0;
  if (strainWeight_ != 0) cost += strainWeight_ * strainAt(edge);
  if (curvatureWeight_ != 0) cost += curvatureWeight_ * guidance_.curvature[nearestVertex(target, edge)];
  return cost;
}

// limber's price of an edge's size, higher where it strains.
double CostModel::sizeCost(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const double strain = strainWeight_ != 0 ? strainWeight_ * strainAt(edge) : 0;
  return lengthScale_ * sizeWeight_ * (1 + strain) * squaredLength(mesh_.position(b) - mesh_.position(a));
}

// The larger strain at the ends of an edge.
double CostModel::strainAt(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  if (method_ == Method::Limber) return std::max(strainOfVertex_[a], strainOfVertex_[b]);
  return std::max(guidance_.strain[triangleOfVertex_[a]], guidance_.strain[triangleOfVertex_[b]]);
}

// The input vertex that is nearest to the target of an edge.
uint32_t CostModel::nearestVertex(const Vec3& target, uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const double toA = squaredLength(target - mesh_.position(a)),
               toB = squaredLength(target - mesh_.position(b));
  const uint32_t guess = vertexOfVertex_[toA <= toB ? a : b];
  return toA == 0 || toB == 0 ? guess : nearestVertex_.find(inFile(target), guess);
}

// E_tri_q (Eq. 10) as the mean over the triangles that the collapse changes, after it; 0 if there are none.
// The paper does not say how the triangles of one collapse make one number.
double CostModel::meanBadness(uint32_t edge, const Vec3& target) const {
  if (qualityWeight_ == 0) return 0;
  double sum = 0;
  int count = 0;
  forEachChanged(edge, [&](const Vec3& q, const Vec3& r) {
    sum += 1 - triangleQuality(target, q, r);
    ++count;
  });
  return count > 0 ? sum / count : 0;
}

double CostModel::worstQuality(uint32_t edge, const Vec3& target) const {
  const Point<RealPair> p = asPair(target, target);
  RealPair worst{1, 1};
  const Vec3 *firstQ = nullptr, *firstR = nullptr;  // a triangle that waits for a second one
  const auto take = [&](const Vec3& q, const Vec3& r) {
    const RealPair quality = squaredTriangleQuality(p, asPair(*firstQ, q), asPair(*firstR, r));
    worst = quality < worst ? quality : worst;
    firstQ = nullptr;
  };
  forEachChanged(edge, [&](const Vec3& q, const Vec3& r) {
    if (firstQ != nullptr) return take(q, r);
    firstQ = &q;
    firstR = &r;
  });
  if (firstQ != nullptr) take(*firstQ, *firstR);
  return std::sqrt(std::min(worst[0], worst[1]));
}

double CostModel::worstQualityAround(uint32_t edge) const {
  double worst = 1;
  const auto [first, second] = mesh_.edge(edge);
  for (const uint32_t v : {first, second})
    for (const Corner corner : mesh_.star(v)) {
      const auto& [a, b, c] = mesh_.face(corner.triangle()).vertices;
      worst = std::min(worst, triangleQuality(mesh_.position(a), mesh_.position(b), mesh_.position(c)));
    }
  return worst;
}

// Calls visit with the two corners that stay, of every triangle that a collapse changes and does not take.
template <class Visit>
void CostModel::forEachChanged(uint32_t edge, const Visit& visit) const {
  const auto [a, b] = mesh_.edge(edge);
  for (uint32_t v : {a, b})
    for (const Corner corner : mesh_.star(v)) {
      const auto& [vertices, edges] = mesh_.face(corner.triangle());
      const int next = nextIndex(corner.index()), previous = previousIndex(corner.index());
      if (edges[next] == edge || edges[previous] == edge) continue;
      visit(mesh_.position(vertices[next]), mesh_.position(vertices[previous]));
    }
}

void CostModel::collapse(const Collapse& step) {
  if (!strainOfVertex_.empty()) {
    const double kept = mesh_.quadric(step.kept).area, removed = mesh_.quadric(step.removed).area;
    float& strain = strainOfVertex_[step.kept];
    if (kept + removed > 0)
      strain =
          static_cast<float>((kept * strain + removed * strainOfVertex_[step.removed]) / (kept + removed));
  }
  attributes_.collapse(step);
  if (!keep_.empty()) keep_[step.kept] = std::max(keep_[step.kept], keep_[step.removed]);
  if (curvatureWeight_ != 0) vertexOfVertex_[step.kept] = nearestVertex(step.target, step.edge);
  if (triangleOfVertex_.empty() || step.target == mesh_.position(step.kept)) return;
  uint32_t& nearest = triangleOfVertex_[step.kept];
  nearest = step.target == mesh_.position(step.removed) ? triangleOfVertex_[step.removed]
                                                        : nearestTriangle_.find(inFile(step.target), nearest);
}

}  // namespace limber
