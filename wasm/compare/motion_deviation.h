#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/surface_point.h"
#include "mesh/triangle_mesh.h"
#include "simulate/simulation.h"

namespace limber {

// The number of points at which a motion deviation is measured.
inline constexpr uint32_t kMotionSamples = 1000;

// Points spread evenly by area over the surface of the original, tracked on one simulated body: the original
// itself, or a result. At rest, each point is bound to the closest point of the body that faces the same way.
class MotionSamples {
 public:
  // `atRest` is the simulation of `body` before its first step.
  MotionSamples(const TriangleMesh& original, const TriangleMesh& body, const Simulation& atRest,
                uint32_t count = kMotionSamples);

  // The displacement of each point from rest, in units of the mesh. For two bodies with the same original and
  // count, point i is the same point of the original.
  std::vector<Vec3> displacements(const Simulation& simulation) const;

 private:
  std::vector<SurfacePoint> points_;
  std::vector<Vec3> rest_;
};

// In % of the diagonal of the original.
struct MotionDeviation {
  double mean = 0, max = 0;
};

// The deviation between the displacements of the same points on two bodies: after one step, or after all
// steps of a run, one after the other. This is the only definition of motion deviation, for reports and for
// the page.
MotionDeviation motionDeviation(std::span<const Vec3> original, std::span<const Vec3> other, double diagonal);

}  // namespace limber
