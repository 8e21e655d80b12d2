#include "simulate/constraints/point_constraints.h"

namespace limber {

void PointConstraints::add(const TriangleMesh& mesh, const Particles& particles, const SurfacePoint& on) {
  Point point{};
  double weight = 0;
  for (int c = 0; c < 3; ++c) {
    point.vertex[c] = mesh.triangles[on.triangle][c];
    point.share[c] = static_cast<float>(on.barycentric[c]);
    weight += particles.inverseMass[point.vertex[c]] * on.barycentric[c] * on.barycentric[c];
  }
  for (int c = 0; c < 3 && weight > 0; ++c)
    point.correction[c] =
        static_cast<float>(particles.inverseMass[point.vertex[c]] * on.barycentric[c] / weight);
  points_.push_back(point);
}

Vec3 PointConstraints::position(size_t i, const Particles& particles) const {
  Vec3 sum;
  for (int c = 0; c < 3; ++c) sum += particles.positions[points_[i].vertex[c]] * double{points_[i].share[c]};
  return sum;
}

void PointConstraints::rebase(size_t i, const Particles& particles, const Path& path, int substeps) {
  points_[i].gap = toFloat4(position(i, particles) - path.from);
  points_[i].targetMove = toFloat4((path.to - path.from) / substeps);
}

void PointConstraints::project(Particles& particles, int substep) const {
  const Float4 done = splat(static_cast<float>(substep + 1));
  for (const Point& point : points_) {
    Float4 gap = point.gap - done * point.targetMove;
    for (int c = 0; c < 3; ++c) {
      const Motion& motion = particles.motion[point.vertex[c]];
      gap += splat(point.share[c]) * (motion.u + motion.q);
    }
    for (int c = 0; c < 3; ++c) particles.motion[point.vertex[c]].q -= splat(point.correction[c]) * gap;
  }
}

}  // namespace limber
