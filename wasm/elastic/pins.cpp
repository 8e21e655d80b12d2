#include "elastic/pins.h"

#include <algorithm>
#include <cmath>

namespace limber {

namespace {

constexpr double kSamePoint = 1e-6;  // of the body's size

}  // namespace

uint32_t rigidMotionsLeft(const std::vector<Vec3>& held) {
  if (held.empty()) return 6;
  const auto distance = [&](const Vec3& p) { return length(p - held[0]); };
  const Vec3 farthest = *std::max_element(
      held.begin(), held.end(), [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
  if (distance(farthest) < kSamePoint) return 3;
  const Vec3 line = normalized(farthest - held[0]);
  const bool isFeature = std::all_of(
      held.begin(), held.end(), [&](const Vec3& p) { return length(cross(p - held[0], line)) < kSamePoint; });
  return isFeature ? 1 : 0;
}

void holdUnknowns(StiffnessModel& model, const std::vector<uint32_t>& unknowns) {
  std::vector<uint8_t> isHeld(model.unknownCount(), 0);
  for (uint32_t u : unknowns) isHeld[u] = 1;
  const double typical = model.stiffness.diagonal().mean();
  for (Eigen::Index column = 0; column < model.stiffness.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(model.stiffness, column); entry; ++entry)
      if (isHeld[static_cast<size_t>(column)] || isHeld[static_cast<size_t>(entry.row())])
        entry.valueRef() = entry.row() == column ? typical : 0;
  for (uint32_t u : unknowns) model.mass[u] = 0;
}

void holdPoint(StiffnessModel& model, const EmbeddedPoint& point, double stiffness) {
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      const double value = stiffness * point.weights[i] * point.weights[j];
      if (value == 0) continue;
      for (uint32_t axis = 0; axis < 3; ++axis)
        model.stiffness.coeffRef(model.firstUnknown[point.nodes[i]] + axis,
                                 model.firstUnknown[point.nodes[j]] + axis) += value;
    }
}

}  // namespace limber
