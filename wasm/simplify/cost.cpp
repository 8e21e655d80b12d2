#include "simplify/cost.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limber {
namespace {

constexpr double kFrameDiagonal = 300;
constexpr double kBorderWeight = 10;
constexpr double kShortness = 1e-9;
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
      sizeWeight_(kShortness + options.sizeWeight),
      guidance_(guidance) {
  lengthScale_ *= lengthScale_;
  collectQuadrics();
  if (options.method == Method::Qem) return;
  strainWeight_ = guidance.strain.empty() ? 0 : options.strainWeight;
  curvatureWeight_ = guidance.curvature.empty() ? 0 : options.curvatureWeight;
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
    Quadric plane;
    addPlane(plane, normal, p, area);
    plane.area = area;
    for (uint32_t v : vertices) quadrics_[v] += plane;
    for (int c = 0; c < 3; ++c) {
      if (mesh_.trianglesOnEdge(edges[c]) != 1) continue;
      const uint32_t from = vertices[nextIndex(c)], to = vertices[previousIndex(c)];
      const Vec3 along = mesh_.position(to) - mesh_.position(from);
      Quadric border;
      addPlane(border, normalized(cross(along, normal)), mesh_.position(from),
               kBorderWeight * squaredLength(along));
      quadrics_[from] += border;
      quadrics_[to] += border;
    }
  }
}

// An input vertex is its own nearest vertex, and its nearest triangle is one of those around it.
void CostModel::startGuidance(const TriangleMesh& input) {
  if (strainWeight_ != 0) {
    nearestTriangle_ = NearestTriangle(input);
    strain_.assign(mesh_.vertexCount(), 0);
    for (uint32_t v = 0; v < mesh_.vertexCount(); ++v)
      if (const uint32_t t = nearestTriangle_.findAround(v, mesh_.star(v)); t != kNone)
        strain_[v] = guidance_.strain[t];
  }
  if (curvatureWeight_ != 0) {
    nearestVertex_ = NearestVertex(input);
    curvature_.assign(guidance_.curvature.begin(), guidance_.curvature.end());
  }
  guidanceCosts_.assign(mesh_.edgeCount(), 0);
}

Vec3 CostModel::inFile(const Vec3& p) const {
  const auto [x, y, z] = mesh_.inFile(p);
  return {x, y, z};
}

Placement CostModel::place(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Vec3 &p = mesh_.position(a), &q = mesh_.position(b);
  const Quadric sum = quadrics_[a] + quadrics_[b];
  const auto at = [&](const Vec3& target) {
    return Placement{target,
                     lengthScale_ * (normalizedError(sum, target) + sizeWeight_ * squaredLength(q - p))};
  };
  const bool aOnBorder = mesh_.freedom(a) == Freedom::Border, bOnBorder = mesh_.freedom(b) == Freedom::Border;
  if (aOnBorder != bOnBorder) return at(mesh_.stored(aOnBorder ? p : q));

  const Vec3 middle = (p + q) * 0.5;
  const Vec3 optimum = minimize(sum, middle);
  if (squaredLength(optimum - middle) <= kReach * kReach * squaredLength(q - p))
    return at(mesh_.rounded(optimum));
  const Placement choices[] = {at(mesh_.rounded(middle)), at(mesh_.stored(p)), at(mesh_.stored(q))};
  return *std::ranges::min_element(choices, {}, &Placement::error);
}

double CostModel::evaluate(uint32_t edge) {
  const Placement placement = place(edge);
  if (guidanceCosts_.empty()) return placement.error;
  guidanceCosts_[edge] = static_cast<float>(guidanceCost(edge, placement.target));
  return placement.error + guidanceCosts_[edge] + qualityWeight_ * meanBadness(edge, placement.target);
}

double CostModel::revalue(uint32_t edge) const {
  const Placement placement = place(edge);
  return placement.error + guidanceCosts_[edge] + qualityWeight_ * meanBadness(edge, placement.target);
}

// alpha E_strain + beta E_curv (Eq. 8).
double CostModel::guidanceCost(uint32_t edge, const Vec3& target) const {
  const auto [a, b] = mesh_.edge(edge);
  double cost = 0;
  if (strainWeight_ != 0) cost += strainWeight_ * std::max(strain_[a], strain_[b]);
  if (curvatureWeight_ != 0) {
    const bool stays = target == mesh_.position(a) || target == mesh_.position(b);
    const float curvature = stays ? curvature_[target == mesh_.position(a) ? a : b]
                                  : guidance_.curvature[nearestVertex_.find(inFile(target))];
    cost += curvatureWeight_ * curvature;
  }
  return cost;
}

// E_tri_q (Eq. 10) as the mean over the triangles that the collapse changes, after it; 0 if there are none.
// The paper does not say how the triangles of one collapse make one number.
double CostModel::meanBadness(uint32_t edge, const Vec3& target) const {
  if (qualityWeight_ == 0) return 0;
  double sum = 0;
  int count = 0;
  const auto [a, b] = mesh_.edge(edge);
  for (uint32_t v : {a, b})
    for (const Corner corner : mesh_.star(v)) {
      const auto& [vertices, edges] = mesh_.face(triangleOf(corner));
      const int next = nextIndex(indexOf(corner)), previous = previousIndex(indexOf(corner));
      if (edges[next] == edge || edges[previous] == edge) continue;
      sum += 1 - triangleQuality(target, mesh_.position(vertices[next]), mesh_.position(vertices[previous]));
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

void CostModel::collapse(const Collapse& step) {
  quadrics_[step.kept] += quadrics_[step.removed];
  const auto carryOver = [&](std::vector<float>& field, const auto& lookUp) {
    if (step.target == mesh_.position(step.kept)) return;
    field[step.kept] = step.target == mesh_.position(step.removed) ? field[step.removed] : lookUp();
  };
  if (strainWeight_ != 0)
    carryOver(strain_, [&] { return guidance_.strain[nearestTriangle_.find(inFile(step.target))]; });
  if (curvatureWeight_ != 0)
    carryOver(curvature_, [&] { return guidance_.curvature[nearestVertex_.find(inFile(step.target))]; });
}

}  // namespace limber
