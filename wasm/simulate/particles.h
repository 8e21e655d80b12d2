#pragma once

#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "simulate/float4.h"

namespace limber {

inline Float4 toFloat4(const Vec3& v) {
  return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
}

// How far a vertex has come within the running step, u, and how far it moves in the running substep, q, which
// is its velocity times the substep. Both are (x, y, z, 0) in metres. Float positions would stand still under
// many substeps (gravity adds less than half a unit in the last place); here the constraints change q alone,
// which is small, and u starts at 0 with every step.
struct Motion {
  Float4 u, q;
};

// The state of all vertices. Positions are exact between steps, in double; within a step a vertex is at
// position + u + q. After the mesh's vertices the motions and masses have some more, for each group of
// constraints one: these never move, and fill the lanes that the group's batches leave empty. They lie two
// cache lines apart, for threads that write to the same line wait for each other.
struct Particles {
  std::vector<Vec3> positions;       // metres, at the start of the step
  std::vector<double> inverseMass;   // 1/kg; 0: its motion is given
  std::vector<Motion> motion;        // of the step
  std::vector<Motion> lost;          // what the sums u and q have lost to rounding (Kahan)
  std::vector<Float4> acceleration;  // m/s2 times the substep squared; 0 where the motion is given
  std::vector<float> damping;        // share of q that is lost in a substep; 0 where the motion is given

  static constexpr uint32_t kIdleStride = 4;

  uint32_t count() const { return static_cast<uint32_t>(positions.size()); }
  uint32_t idle(uint32_t group) const { return count() + kIdleStride * group; }
};

// What `advance` does: move along q (not before the first substep), then change q (not after the last one).
struct Advance {
  bool moves, accelerates;
};

// u += q, then q += acceleration - damping q, for vertices [begin, end); the sums are compensated.
void advance(Particles& particles, uint32_t begin, uint32_t end, const Advance& what);

// Adds u to the positions and starts again at u = 0.
void finishStep(Particles& particles, uint32_t begin, uint32_t end);

}  // namespace limber
