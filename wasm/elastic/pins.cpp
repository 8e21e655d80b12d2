#include "elastic/pins.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kSamePoint = 1e-6;  // of the size of the body

}  // namespace

uint32_t rigidMotionsLeft(const std::vector<Vec3>& points) {
  if (points.empty()) return 6;
  const auto distance = [&](const Vec3& p) { return length(p - points[0]); };
  const Vec3 farthest = *std::max_element(
      points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  if (distance(farthest) < kSamePoint) return 3;
  const Vec3 line = normalized(farthest - points[0]);
  const bool isLine = std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return length(cross(p - points[0], line)) < kSamePoint;
  });
  return isLine ? 1 : 0;
}

uint32_t rigidMotionsLeft(const TriangleMesh& mesh, std::span<const uint32_t> pinned) {
  std::vector<Vec3> points;
  for (const uint32_t v : pinned) points.push_back(mesh.positions[v]);
  return rigidMotionsLeft(points);
}

void clampUnknowns(SparsePencil& pencil, const std::vector<uint32_t>& unknowns) {
  std::vector<uint8_t> isClamped(pencil.unknownCount(), 0);
  for (uint32_t u : unknowns) isClamped[u] = 1;
  const double typical = pencil.k.diagonal().mean();
  for (Eigen::Index column = 0; column < pencil.k.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(pencil.k, column); entry; ++entry)
      if (isClamped[static_cast<size_t>(column)] || isClamped[static_cast<size_t>(entry.row())])
        entry.valueRef() = entry.row() == column ? typical : 0;
  for (uint32_t u : unknowns) pencil.m[u] = 0;
}

void addPointSpring(SparsePencil& pencil, const EmbeddedPoint& point, double stiffness) {
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double value = stiffness * point.weights[i] * point.weights[j];
      if (value == 0) continue;
      for (uint32_t axis = 0; axis < 3; ++axis)
        pencil.k.coeffRef(pencil.firstUnknown[point.nodes[i]] + axis,
                          pencil.firstUnknown[point.nodes[j]] + axis) += value;
    }
}

}  // namespace limber
