#include "simplify/cost/attribute_quadrics.h"

#include <algorithm>
#include <array>

namespace limber {
namespace {

constexpr uint32_t kMatrix = 0, kVector = 6, kConstant = 9, kArea = kFormSize, kTextureArea = kArea + 1;
// A triangle whose height is a smaller part of its longest edge has no meaningful gradient.
constexpr double kSmallestHeight = 1e-4;
// The weight of a displacement within the surface relative to one across it: small, but enough for a
// meaningful order of collapses in flat sheets that move within their plane. Twice as much or none at all
// changes pictures of a fox by a quarter of a dB on average; docs/pictures.md has the curve.
constexpr double kWithinSurface = 0.05;

}  // namespace

AttributeQuadrics::AttributeQuadrics(const CollapseMesh& mesh, const SimplifyConstraints& constraints)
    : mesh_(mesh) {
  if (constraints.attributes.empty()) return;
  dimension_ = constraints.attributeDimension;
  displacements_ = constraints.displacementFields;
  scalars_ = dimension_ - 3 * displacements_;
  stride_ = displacementsAt() + displacementSums(displacements_);
  sums_.assign(size_t{mesh.sectorCount()} * stride_, 0);
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) addTriangle(t, constraints);
}

void AttributeQuadrics::addTriangle(uint32_t t, const SimplifyConstraints& constraints) {
  const Triangle& vertices = mesh_.face(t).vertices;
  const Vec3& p = mesh_.position(vertices[0]);
  const Vec3 toQ = mesh_.position(vertices[1]) - p, toR = mesh_.position(vertices[2]) - p;
  const Vec3 normal = cross(toQ, toR);
  const double square = squaredLength(normal), area = 0.5 * length(normal);
  const double longest = std::max({squaredLength(toQ), squaredLength(toR), squaredLength(toR - toQ)});
  if (!(2 * area > kSmallestHeight * longest)) return;
  const Vec3 alongQ = cross(toR, normal) / square, alongR = cross(normal, toQ) / square;
  std::array<LinearField, SimplifyConstraints::kAttributeLimit> fields;
  for (uint32_t j = 0; j < dimension_; ++j) {
    const auto value = [&](int c) {
      const uint32_t row =
          constraints.wedges.empty() ? vertices[c] : constraints.wedges[Corner(t, c).flatIndex()];
      return mesh_.diagonal() * constraints.attributes[size_t{row} * dimension_ + j];
    };
    const double atP = value(0);
    const Vec3 g = alongQ * (value(1) - atP) + alongR * (value(2) - atP);
    fields[j] = {g.x, g.y, g.z, atP - dot(g, p)};
  }
  const double texture = constraints.textureWeights.empty() ? 1 : constraints.textureWeights[t];
  const WeightedMetric triangle{metricAlong(normal / (2 * area), hasBorder(t) ? 1 : kWithinSurface), area};
  for (int c = 0; c < 3; ++c) {
    double* sums = sumsOf(mesh_.sector(Corner(t, c)));
    addScalars(sums, fields.data(), {area, texture * area});
    if (displacements_ > 0)
      addDisplacements(sums + displacementsAt(), sums,
                       std::span(fields).subspan(scalars_, 3 * displacements_), triangle);
  }
}

// A displacement within the surface moves its outline there.
bool AttributeQuadrics::hasBorder(uint32_t t) const {
  return std::ranges::any_of(mesh_.face(t).edges, [&](uint32_t e) { return mesh_.trianglesOnEdge(e) == 1; });
}

void AttributeQuadrics::addScalars(double* sums, const LinearField* fields, const Areas& areas) const {
  sums[kArea] += areas.all;
  sums[kTextureArea] += areas.texture;
  for (uint32_t j = 0; j < scalars_; ++j) {
    const double area = j < kTextureSize ? areas.texture : areas.all;
    addSquare(sums, fields[j], area);
    for (int i = 0; i < 4; ++i) sums[kFields + 4 * j + i] += area * fields[j][i];
  }
}

AttributeQuadrics::Joined AttributeQuadrics::sectorsAt(uint32_t edge, uint32_t first, uint32_t second) const {
  Joined joined{{}, 0};
  for (const Corner corner : mesh_.star(first)) {
    const uint32_t t = corner.triangle();
    const CollapseMesh::Face& face = mesh_.face(t);
    for (int c = 0; c < 3; ++c) {
      if (face.vertices[c] != second) continue;
      if (face.edges[3 - c - corner.index()] != edge) continue;
      const uint32_t atFirst = mesh_.sector(corner), atSecond = mesh_.sector(Corner(t, c));
      const bool known =
          joined.count == 1 && joined.sectors[0][0] == atFirst && joined.sectors[0][1] == atSecond;
      if (known || joined.count == 2) continue;
      joined.sectors[joined.count][0] = atFirst;
      joined.sectors[joined.count++][1] = atSecond;
    }
  }
  return joined;
}

Quadric AttributeQuadrics::residual(uint32_t edge) const {
  const auto [a, b] = mesh_.edge(edge);
  const Joined joined = sectorsAt(edge, a, b);
  Quadric sum{};
  for (int side = 0; side < joined.count; ++side)
    sum = sum + residualOf(joined.sectors[side][0], joined.sectors[side][1]);
  return sum;
}

Quadric AttributeQuadrics::residualOf(uint32_t first, uint32_t second) const {
  const double *p = sumsOf(first), *q = sumsOf(second);
  const double area = p[kArea] + q[kArea];
  if (!(area > 0)) return {};
  double sums[kFormSize];
  for (uint32_t i = 0; i < kFormSize; ++i) sums[i] = p[i] + q[i];
  if (displacements_ > 0)
    takeMeansOff(sums, {p + displacementsAt(), q + displacementsAt()}, displacements_, area);
  for (uint32_t j = 0; j < scalars_; ++j) {
    const uint32_t at = kFields + 4 * j;
    const double x = p[at] + q[at], y = p[at + 1] + q[at + 1], z = p[at + 2] + q[at + 2];
    const uint32_t areaOfField = j < kTextureSize ? kTextureArea : kArea;
    const double d = p[at + 3] + q[at + 3], ofField = p[areaOfField] + q[areaOfField];
    if (!(ofField > 0)) continue;
    const double inverse = 1 / ofField;
    const double products[] = {x * x, x * y, x * z, y * y, y * z, z * z, d * x, d * y, d * z, d * d};
    for (uint32_t i = 0; i < kFormSize; ++i) sums[i] -= inverse * products[i];
  }
  return {sums[0],         sums[1], sums[2], sums[3], sums[4], sums[5], {sums[kVector], sums[7], sums[8]},
          sums[kConstant], 0};
}

void AttributeQuadrics::collapse(const Collapse& step) {
  if (empty()) return;
  const Joined joined = sectorsAt(step.edge, step.removed, step.kept);
  for (int side = 0; side < joined.count; ++side) {
    const double* from = sumsOf(joined.sectors[side][0]);
    double* to = sumsOf(joined.sectors[side][1]);
    for (uint32_t i = 0; i < stride_; ++i) to[i] += from[i];
  }
}

}  // namespace limber
