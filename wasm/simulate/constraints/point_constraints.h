#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"
#include "simulate/particles.h"

namespace limber {

// Points of the surface that are pinned to a target, which moves uniformly during the step. Hard constraints:
// they have no compliance.
class PointConstraints {
 public:
  void add(const TriangleMesh& mesh, const Particles& particles, const SurfacePoint& on);
  void clear() { points_.clear(); }
  size_t count() const { return points_.size(); }

  struct Path {
    Vec3 from, to;
  };
  // The target of a dragged point within a step: a fifth of the remaining way to its actual target, as a hand
  // would pull it.
  static Path dragged(const Vec3& from, const Vec3& target) { return {from, from + (target - from) * 0.2}; }
  // Sets how the target of point i moves within the step, in metres.
  void rebase(size_t i, const Particles& particles, const Path& path, int substeps);
  // One pass over all points in order. `substep` counts from 0 within the step.
  void project(Particles& particles, int substep) const;

  // The position of point i between steps, in metres.
  Vec3 position(size_t i, const Particles& particles) const;

 private:
  struct Point {
    uint32_t vertex[3];
    float share[3];       // barycentric
    float correction[3];  // w share / sum w share^2
    Float4 gap;           // point - target at the start of the step
    Float4 targetMove;    // of the target per substep
  };
  std::vector<Point> points_;
};

}  // namespace limber
