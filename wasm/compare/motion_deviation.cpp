#include "compare/motion_deviation.h"

#include <algorithm>

#include "mesh/surface_samples.h"
#include "query/closest_point.h"

namespace limber {

MotionSamples::MotionSamples(const TriangleMesh& original, const TriangleMesh& body, const Simulation& atRest,
                             uint32_t count) {
  if (count == 0) return;
  const SurfaceSamples samples = sampleSurface(original, count);
  const ClosestPointTree tree(body);
  for (size_t i = 0; i < samples.positions.size(); ++i) {
    const Vec3 normal = normalized(areaNormal(original, samples.triangles[i]));
    const ClosestPoint on = tree.closestFacing(samples.positions[i], normal);
    points_.push_back({on.triangle, {on.barycentric[0], on.barycentric[1], on.barycentric[2]}});
    rest_.push_back(atRest.position(points_.back()));
  }
}

std::vector<Vec3> MotionSamples::displacements(const Simulation& simulation) const {
  std::vector<Vec3> displacements;
  displacements.reserve(points_.size());
  for (size_t i = 0; i < points_.size(); ++i)
    displacements.push_back(simulation.position(points_[i]) - rest_[i]);
  return displacements;
}

MotionDeviation motionDeviation(std::span<const Vec3> original, std::span<const Vec3> other,
                                double diagonal) {
  const double percent = 100 / diagonal;
  MotionDeviation deviation;
  for (size_t i = 0; i < original.size(); ++i) {
    const double distance = percent * length(original[i] - other[i]);
    deviation.mean += distance / static_cast<double>(original.size());
    deviation.max = std::max(deviation.max, distance);
  }
  return deviation;
}

}  // namespace limber
