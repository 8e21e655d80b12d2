#include "fields/strain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace limber {

namespace {

constexpr size_t kGrain = 4096;  // triangles of a range for one thread

// A symmetric 2 x 2 matrix [a b; b c].
struct Symmetric2 {
  double a, b, c;
};

// Two edges of a rest triangle in its tangent frame: (px, 0) and (qx, qy).
struct RestEdges {
  double px, qx, qy;
};

// F^T F of a triangle whose rest edges are deformed to u and v: the columns of F are u / px and (v - u qx /
// px) / qy.
Symmetric2 rightCauchyGreen(const RestEdges& rest, const Vec3& u, const Vec3& v) {
  const Vec3 first = u / rest.px;
  const Vec3 second = (v - first * rest.qx) / rest.qy;
  return {dot(first, first), dot(first, second), dot(second, second)};
}

double triangleStrain(const TriangleMesh& mesh, uint32_t t, std::span<const float> shape, double amplitude) {
  const Vec3 p = mesh.corner(t, 1) - mesh.corner(t, 0), q = mesh.corner(t, 2) - mesh.corner(t, 0);
  const double px = length(p);
  const double height = length(cross(p, q)) / (px > 0 ? px : 1);
  if (!(px > 0) || !(height > 0)) return 0;
  const auto displacement = [&](int c) {
    const size_t v = 3 * size_t{mesh.triangles[t][c]};
    return Vec3{shape[v], shape[v + 1], shape[v + 2]} * amplitude;
  };
  const Vec3 base = displacement(0);
  const Vec3 u = p + displacement(1) - base, v = q + displacement(2) - base;
  const Symmetric2 c = rightCauchyGreen({px, dot(p, q) / px, height}, u, v);
  const double exx = (c.a - 1) / 2, eyy = (c.c - 1) / 2, exy = c.b / 2;
  const double strain = std::sqrt(exx * exx + eyy * eyy + 2 * exy * exy);
  return std::isfinite(strain) ? strain : 0;
}

}  // namespace

std::vector<double> greenLagrangeStrain(const TriangleMesh& mesh, std::span<const float> shape,
                                        double amplitude) {
  std::vector<double> strain(mesh.triangleCount());
  parallelFor(strain.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t)
      strain[t] = triangleStrain(mesh, static_cast<uint32_t>(t), shape, amplitude);
  });
  return strain;
}

std::vector<double> combineStrain(std::span<const WeightedStrain> ordinals,
                                  std::span<const uint32_t> componentOfTriangle, double p) {
  const auto combined = [&](size_t t) {
    double sum = 0;
    for (const WeightedStrain& ordinal : ordinals) {
      const double weight = ordinal.weightOfComponent[componentOfTriangle[t]];
      const double strain = std::isinf(p) ? ordinal.strain[t] : std::pow(ordinal.strain[t], p);
      if (weight == 0 || strain == 0) continue;  // either may be infinite, and the product would be NaN
      sum = std::isinf(p) ? std::max(sum, weight * strain) : sum + weight * strain;
    }
    return std::isinf(p) ? sum : std::pow(sum, 1 / p);
  };
  std::vector<double> sigma(componentOfTriangle.size());
  parallelFor(sigma.size(), kGrain, [&](size_t begin, size_t end) {
    for (size_t t = begin; t < end; ++t) sigma[t] = combined(t);
  });
  return sigma;
}

std::vector<float> rankWithin(std::span<const double> values, std::span<const uint32_t> group,
                              uint32_t groupCount) {
  std::vector<uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    if (group[a] != group[b]) return group[a] < group[b];
    if (values[a] != values[b]) return values[a] < values[b];
    return a < b;
  });
  std::vector<size_t> groupSize(groupCount, 0);
  for (uint32_t g : group) ++groupSize[g];

  std::vector<float> rank(values.size());
  size_t groupStart = 0;
  for (size_t begin = 0; begin < order.size();) {
    const uint32_t g = group[order[begin]];
    if (begin > 0 && group[order[begin - 1]] != g) groupStart = begin;
    size_t end = begin;
    while (end < order.size() && group[order[end]] == g && values[order[end]] == values[order[begin]]) ++end;
    const double middle = static_cast<double>(begin - groupStart) + 0.5 * static_cast<double>(end - begin);
    for (size_t i = begin; i < end; ++i)
      rank[order[i]] = static_cast<float>(middle / static_cast<double>(groupSize[g]));
    begin = end;
  }
  return rank;
}

}  // namespace limber
