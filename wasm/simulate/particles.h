#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "simulate/float4.h"

namespace limber {

inline Float4 toFloat4(const Vec3& v) {
  return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}

// The first three entries.
inline Vec3 toVec3(Float4 a) {
  return {double{a[0]}, double{a[1]}, double{a[2]}};
}

// The motion of a vertex: u is its displacement since the start of the step, q that in this substep, which is
// its velocity times the substep. Both are (x, y, z, 0) in metres. With many substeps, float positions would
// not move at all, because gravity adds less than half a unit in the last place. Here constraints only change
// q, which is small, and u starts at 0 in every step.
struct Motion {
  Float4 u, q;
};

// The state of all vertices. Positions are doubles and change only between steps; within a step a vertex is
// at position + u + q. After the vertices of the mesh, `motion` and `inverseMass` have an idle vertex per
// group of constraints, which never moves and fills the empty lanes of the group's batches. Idle vertices lie
// two cache lines apart, because threads that write to the same line wait for each other.
struct Particles {
  std::vector<Vec3> positions;       // metres, at the start of the step
  std::vector<double> inverseMass;   // 1/kg; 0 for a pinned vertex
  std::vector<Motion> motion;        // within the step
  std::vector<Motion> lost;          // the rounding errors of the sums u and q (Kahan summation)
  std::vector<Float4> acceleration;  // m/s2 times the substep squared; 0 for a pinned vertex
  std::vector<float> damping;        // the share of q that a substep removes; 0 for a pinned vertex

  static constexpr uint32_t kIdleStride = 4;

  uint32_t count() const { return static_cast<uint32_t>(positions.size()); }
  uint32_t idle(uint32_t group) const { return count() + kIdleStride * group; }
};

// The parts of `advance`: it moves vertices by q (not before the first substep), then changes q by
// acceleration and damping (not after the last one).
struct Advance {
  bool moves, accelerates;
};

// For vertices [begin, end): u += q, then q += acceleration - damping q, as `what` says. The sums are
// compensated.
void advance(Particles& particles, uint32_t begin, uint32_t end, const Advance& what);

// For vertices [begin, end): adds u to the positions and sets u = 0.
void finishStep(Particles& particles, uint32_t begin, uint32_t end);

}  // namespace limber
