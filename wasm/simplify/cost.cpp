#include "simplify/cost.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace limber {
namespace {

constexpr double kFrameDiagonal = 300;
constexpr double kBorderWeight = 10;
constexpr double kShortness = 1e-9;
constexpr double kWorstQuality = 1e-6;  // keeps the price of a needle finite
// How far from the middle of an edge its target may lie, in lengths of the edge.
constexpr double kReach = 2;

// Eq. 9: 4 sqrt(3) A / (l1^2 + l2^2 + l3^2), 1 for an equilateral triangle, 0 for one without area.
double triangleQuality(const Vec3& p, const Vec3& q, const Vec3& r) {
  const double squares = squaredLength(q - p) + squaredLength(r - q) + squaredLength(p - r);
  return squares > 0 ? 2 * std::numbers::sqrt3 * length(cross(q - p, r - p)) / squares : 0;
}

}  // namespace

CostModel::CostModel(const TriangleMesh& input, const CollapseMesh& mesh, const Guidance& guidance,
                     const SimplifyOptions& options)
    : mesh_(mesh),
      lengthScale_(kFrameDiagonal / mesh.diagonal()),
      method_(options.method),
      shortness_(kShortness + (options.method == Method::Qem ? options.sizeWeight : 0)),
      sizeWeight_(options.sizeWeight),
      guidance_(guidance) {
  lengthScale_ *= lengthScale_;
  collectQuadrics();
  if (options.method == Method::Qem) return;
  strainWeight_ = guidance.strain.empty() ? 0 : options.strainWeight;
  curvatureWeight_ =
      guidance.curvature.empty() || options.method == Method::Limber ? 0 : options.curvatureWeight;
  qualityWeight_ = options.qualityWeight;
  startGuidance(input);
}

void CostModel::collectQuadrics() {
  quadrics_.resize(mesh_.vertexCount());
  for (uint32_t t = 0; t < mesh_.triangleCount(); ++t) {
    const auto& [vertices, edges] = mesh_.face(t);
    const Vec3 &p = mesh_.position(vertices[0]), &q = mesh_.position(vertices[1]),
               &r = mesh_.position(vertices[2]);
    const Vec3 areaNormal = cross(q - p, r - p);
    const double area = 0.5 * length(areaNormal);
    const Vec3 normal = normalized(areaNormal);
    Quadric plane = planeQuadric(normal, p, area);
    plane.area = area;
    for (uint32_t v : vertices) quadrics_[v] = quadrics_[v] + plane;
    for (int c = 0; c < 3; ++c) {
      if (mesh_.trianglesOnEdge(edges[c]) != 1) continue;
      const uint32_t from = vertices[nextIndex(c)], to = vertices[previousIndex(c)];
      const Vec3 along = mesh_.position(to) - mesh_.position(from);
      const Quadric border = planeQuadric(normalized(cross(along, normal)), mesh_.position(from),
                                          kBorderWeight * squaredLength(along));
      for (uint32_t v : {from, to}) quadrics_[v] = quadrics_[v] + border;
    }
  }
}

// An input vertex is its own nearest vertex, and its nearest triangle is one of those around it.
void CostModel::startGuidance(const TriangleMesh& input) {
  if (strainWeight_ != 0) {
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

Placement CostModel::place(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Vec3 &p = mesh_.position(a), &q = mesh_.position(b);
  const Quadric sum = quadrics_[a] + quadrics_[b];
  const auto at = [&](const Vec3& target) {
    const double error = normalizedError(sum, asPoint(target)) + shortness_ * squaredLength(q - p);
    return Placement{target, lengthScale_ * error};
  };
  if (endsOnBorder(edge) == 1) return at(mesh_.stored(mesh_.freedom(a) == Freedom::Border ? p : q));
  const auto optimum = findOptimum(sum, asPoint(p), asPoint(q));
  if (!(optimum.overreach > 0)) return {asVec3(optimum.target), optimum.error};
  const Vec3 middle = asVec3(mesh_.rounded(asPoint((p + q) * 0.5)));
  const Placement choices[] = {at(middle), at(mesh_.stored(p)), at(mesh_.stored(q))};
  return *std::ranges::min_element(choices, {}, &Placement::error);
}

// The same as `place` for each, bit by bit, in less time.
std::array<Placement, 2> CostModel::placeTwo(uint32_t e, uint32_t f) const {
  if (endsOnBorder(e) == 1 || endsOnBorder(f) == 1) return {place(e), place(f)};
  const auto [a, b] = mesh_.edge(e);
  const auto [c, d] = mesh_.edge(f);
  const auto sum = asPair(quadrics_[a] + quadrics_[b], quadrics_[c] + quadrics_[d]);
  const auto optimum = findOptimum(sum, asPair(mesh_.position(a), mesh_.position(c)),
                                   asPair(mesh_.position(b), mesh_.position(d)));
  const auto placement = [&](uint32_t edge, int i) {
    return optimum.overreach[i] > 0 ? place(edge) : Placement{lane(optimum.target, i), optimum.error[i]};
  };
  return {placement(e, 0), placement(f, 1)};
}

// Calls visit(i, place(edges[i])) for every i.
template <class Visit>
void CostModel::placeAll(std::span<const uint32_t> edges, const Visit& visit) const {
  size_t i = 0;
  for (; i + 1 < edges.size(); i += 2) {
    const auto [first, second] = placeTwo(edges[i], edges[i + 1]);
    visit(i, first);
    visit(i + 1, second);
  }
  if (i < edges.size()) visit(i, place(edges[i]));
}

int CostModel::endsOnBorder(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  return (mesh_.freedom(a) == Freedom::Border) + (mesh_.freedom(b) == Freedom::Border);
}

void CostModel::evaluate(std::span<const uint32_t> edges, std::span<double> costs) {
  placeAll(edges, [&](size_t i, const Placement& placement) {
    if (!guidanceCosts_.empty())
      guidanceCosts_[edges[i]] = static_cast<float>(guidanceCost(edges[i], placement.target));
    costs[i] = total(edges[i], placement);
  });
}

void CostModel::revalue(std::span<const uint32_t> edges, std::span<double> costs) const {
  placeAll(edges, [&](size_t i, const Placement& placement) { costs[i] = total(edges[i], placement); });
}

// Eq. 11, limber's product, or E_QEM alone.
double CostModel::total(uint32_t edge, const Placement& placement) const {
  if (guidanceCosts_.empty()) return placement.error;
  if (method_ == Method::Limber) {
    const double badness = 1 / std::max(worstQuality(edge, placement.target), kWorstQuality) - 1;
    return (3 * placement.error + guidanceCosts_[edge]) * (1 + qualityWeight_ * badness);
  }
  return placement.error + guidanceCosts_[edge] + qualityWeight_ * meanBadness(edge, placement.target);
}

// alpha E_strain + beta E_curv (Eq. 8); for limber the price of the edge's size, higher where it strains.
double CostModel::guidanceCost(uint32_t edge, const Vec3& target) const {
  const auto [a, b] = mesh_.edge(edge);
  double cost = 0;
  if (strainWeight_ != 0) {
    const auto strain = [&](uint32_t v) { return guidance_.strain[triangleOfVertex_[v]]; };
    cost += strainWeight_ * std::max(strain(a), strain(b));
  }
  if (method_ == Method::Limber)
    return lengthScale_ * sizeWeight_ * (1 + cost) * squaredLength(mesh_.position(b) - mesh_.position(a));
  if (curvatureWeight_ != 0) cost += curvatureWeight_ * guidance_.curvature[nearestVertex(target, edge)];
  return cost;
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
  double worst = 1;
  forEachChanged(
      edge, [&](const Vec3& q, const Vec3& r) { worst = std::min(worst, triangleQuality(target, q, r)); });
  return worst;
}

// Calls visit with the two corners that stay, of every triangle that a collapse changes and does not take.
template <class Visit>
void CostModel::forEachChanged(uint32_t edge, const Visit& visit) const {
  const auto [a, b] = mesh_.edge(edge);
  for (uint32_t v : {a, b})
    for (const Corner corner : mesh_.star(v)) {
      const auto& [vertices, edges] = mesh_.face(triangleOf(corner));
      const int next = nextIndex(indexOf(corner)), previous = previousIndex(indexOf(corner));
      if (edges[next] == edge || edges[previous] == edge) continue;
      visit(mesh_.position(vertices[next]), mesh_.position(vertices[previous]));
    }
}

void CostModel::collapse(const Collapse& step) {
  quadrics_[step.kept] = quadrics_[step.kept] + quadrics_[step.removed];
  if (curvatureWeight_ != 0) vertexOfVertex_[step.kept] = nearestVertex(step.target, step.edge);
  if (strainWeight_ == 0 || step.target == mesh_.position(step.kept)) return;
  uint32_t& nearest = triangleOfVertex_[step.kept];
  nearest = step.target == mesh_.position(step.removed) ? triangleOfVertex_[step.removed]
                                                        : nearestTriangle_.find(inFile(step.target), nearest);
}

}  // namespace limber
