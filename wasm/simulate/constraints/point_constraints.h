#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulate/particles.h"
#include "simulate/simulation.h"

namespace limber {

// Points of the surface that are held at a target, which moves evenly through the step.
class PointConstraints {
 public:
  void add(const TriangleMesh& mesh, const Particles& particles, const SurfacePoint& anchor);
  void clear() { points_.clear(); }
  size_t count() const { return points_.size(); }

  struct Way {
    Vec3 from, to;
  };
  // Metres: where the target of point i goes within the step.
  void rebase(size_t i, const Particles& particles, const Way& way, int substeps);
  // One pass over all points in order, for the given substep of the step, from 0.
  void project(Particles& particles, int substep) const;

  // Where the point is between steps, in metres.
  Vec3 position(size_t i, const Particles& particles) const;

 private:
  struct Point {
    uint32_t vertex[3];
    float share[3];       // barycentric
    float correction[3];  // w share / sum w share^2
    Float4 gap;           // point - target at the start of the step
    Float4 targetMove;    // of the target in a substep
  };
  std::vector<Point> points_;
};

}  // namespace limber
