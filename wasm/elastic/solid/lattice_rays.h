#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/job.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// Sample points per cell along each axis. The rays along all three axes pass through them.
inline constexpr int kSamples = 6;

// The position of sample s along an axis of a cell, in [0, 1]: the middle of its part of the cell, plus an
// offset that keeps rays off the planes of symmetry of a body.
inline double samplePosition(int axis, int s) {
  constexpr double offset[3] = {1.7320508e-4, 2.2360680e-4, -1.4142136e-4};
  return (s + 0.5) / kSamples + offset[axis];
}

// A line parallel to an axis, with the coordinates u and v along axis + 1 and axis + 2 (modulo 3).
struct AxisLine {
  int axis;
  double u, v;
};

struct LineHit {
  double depth;  // the coordinate along the axis
  bool isEntry;  // the line runs against the normal of the triangle
};
// The point where a line crosses a triangle, if it does. For two triangles with a common edge the decision
// which of them the line crosses is consistent to the last bit, so a closed surface has no cracks.
std::optional<LineHit> hitTriangle(const std::vector<Vec3>& points, const Triangle& triangle,
                                   const AxisLine& line);

// The rays along one axis through all sample points. With u = axis + 1 and v = axis + 2 (modulo 3), the ray
// through the samples a along u and b along v, counted over all cells, has the id a * (count[v] * kSamples) +
// b.
struct RayFamily {
  struct Crossing {
    uint32_t ray, triangle;
    double depth;  // along the ray, in lattice units
    bool isEntry;  // from the outside to the inside of that triangle
  };
  // A part of a ray within the body: from the crossing `first` to the crossing `last`, including those in
  // between.
  struct Interval {
    uint32_t first, last;
  };
  int axis = 0;
  std::vector<Crossing> crossings;  // by ray, then by depth
  std::vector<Interval> intervals;
};

// Casts the rays along `axis`. They are inside the surface where the winding number times its sign is
// positive. Rays whose winding number does not return to 0 pass through a hole and are dropped. Throws
// Cancelled.
RayFamily castRays(const LatticeSurface& surface, int axis, Job& job);

}  // namespace limber
