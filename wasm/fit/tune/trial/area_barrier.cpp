#include "fit/tune/trial/area_barrier.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elastic/shell_element.h"

namespace limber {
namespace {

// The area over that at rest below which the barrier acts.
constexpr double kCompression = std::numbers::inv_sqrt3;

Vec3 doubleNormal(const std::array<uint32_t, 3>& vertices, std::span<const Vec3> positions) {
  const auto& [a, b, c] = vertices;
  return cross(positions[b] - positions[a], positions[c] - positions[a]);
}

}  // namespace

AreaBarrier::AreaBarrier(std::span<const std::array<uint32_t, 3>> triangles, std::span<const Vec3> rest,
                         double stiffness) {
  if (!(stiffness > 0)) return;
  for (const std::array<uint32_t, 3>& vertices : triangles) {
    double longest = 0;
    for (int c = 0; c < 3; ++c)
      longest = std::max(longest, squaredLength(rest[vertices[(c + 1) % 3]] - rest[vertices[c]]));
    const double doubleArea = length(doubleNormal(vertices, rest));
    const double flatness = longest > 0 ? doubleArea / longest : 0;
    if (flatness < kDegenerateTriangle) continue;
    const double root = std::sqrt(stiffness * 0.5 * doubleArea * std::min(1.0, flatness / kFlattestTriangle));
    triangles_.push_back({vertices, root, kCompression * doubleArea});
  }
}

bool AreaBarrier::isActive(size_t i, std::span<const Vec3> positions) const {
  const double least = triangles_[i].doubleArea;
  return squaredLength(doubleNormal(triangles_[i].vertices, positions)) < least * least;
}

// The derivative of twice the area with respect to a corner is the unit normal x the edge opposite to it.
ConstraintStrain AreaBarrier::strainAt(size_t i, std::span<const Vec3> positions) const {
  ConstraintStrain result;
  const auto& [vertices, root, least] = triangles_[i];
  const Vec3 normal = doubleNormal(vertices, positions);
  const double doubleArea = length(normal);
  if (!(doubleArea < least)) return result;
  result.strain[0] = root * std::log(least / doubleArea);
  if (doubleArea == 0) return result;
  const Vec3 scaled = normal * (-root / (doubleArea * doubleArea));
  for (int c = 0; c < 3; ++c) {
    const Vec3 gradient = cross(scaled, positions[vertices[(c + 2) % 3]] - positions[vertices[(c + 1) % 3]]);
    for (int axis = 0; axis < 3; ++axis) result.jacobian(0, 3 * c + axis) = gradient[axis];
  }
  return result;
}

double AreaBarrier::energyAt(std::span<const Vec3> positions) const {
  double sum = 0;
  for (size_t i = 0; i < count(); ++i) {
    if (!isActive(i, positions)) continue;
    const double doubleArea = length(doubleNormal(triangles_[i].vertices, positions));
    const double strain = triangles_[i].root * std::log(triangles_[i].doubleArea / doubleArea);
    sum += 0.5 * strain * strain;
  }
  return sum;
}

}  // namespace limber
