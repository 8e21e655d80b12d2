#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/job.h"
#include "elastic/solid/lattice_grid.h"

namespace limber {

// Sample points per cell along each axis. The rays along the three axes all run through them.
inline constexpr int kSamples = 6;

// Where sample s of a cell lies along an axis, in [0, 1]: in the middle of its share of the cell, but for an
// offset that keeps rays off the planes of symmetry of a body.
inline double samplePlace(int axis, int s) {
  constexpr double offset[3] = {1.7320508e-4, 2.2360680e-4, -1.4142136e-4};
  return (s + 0.5) / kSamples + offset[axis];
}

// Where the line along `axis` through (u, v), coordinates along axis + 1 and axis + 2, crosses a triangle.
// Two triangles at an edge agree to the last bit on which of them it crosses: a closed surface has no cracks.
struct LineHit {
  double depth;
  bool isEntry;  // against the triangle's normal
};
std::optional<LineHit> hitTriangle(const std::vector<Vec3>& points, const Triangle& triangle, int axis,
                                   double u, double v);

// The rays along one axis through all sample points. Ray (a, b) has the number a * (count[v] * kSamples) + b,
// a and b being sample numbers along u = axis + 1 and v = axis + 2 (modulo 3), over all cells.
struct RayFamily {
  struct Crossing {
    uint32_t ray, triangle;
    double depth;  // along the ray, in lattice units
    bool isEntry;  // from outside to the inside of that triangle
  };
  // A stretch of a ray within the body: from the crossing `first` to `last`, those between included.
  struct Interval {
    uint32_t first, last;
  };
  int axis = 0;
  std::vector<Crossing> crossings;  // by ray, then depth
  std::vector<Interval> intervals;
};

// Where the rays along `axis` are inside of the surface, that is where the winding number is positive (times
// `sign`, -1 for a body that is wound inwards). Rays that are seen to pass through a hole are left out.
// `points`: the vertices in lattice units.
RayFamily castRays(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                   const LatticeGrid& grid, int axis, int sign, Job& job);

}  // namespace limber
