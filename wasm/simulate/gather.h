#pragma once

#include <cstdint>

#include "simulate/particles.h"

namespace limber {

// The motions of four vertices, one per lane. Batches store pointers rather than indices, which saves the
// address arithmetic.
using MotionLanes = Motion* [4];

// The displacements of four vertices since the start of the step, one per lane.
inline Vec3x4 gatherMotion(const MotionLanes& v) {
  const Float4 moved[4] = {v[0]->u + v[0]->q, v[1]->u + v[1]->q, v[2]->u + v[2]->q, v[3]->u + v[3]->q};
  return toLanes(moved);
}

// The vectors of four vertices, one per lane.
inline Vec3x4 gatherLanes(const Float4* vectors, const uint32_t (&v)[4]) {
  const Float4 found[4] = {vectors[v[0]], vectors[v[1]], vectors[v[2]], vectors[v[3]]};
  return toLanes(found);
}

// Adds one correction per lane to the substep motion of four vertices. They must differ, except that the idle
// vertex may occur several times with a correction of 0.
inline void scatterCorrection(const MotionLanes& v, const Vec3x4& correction) {
  Float4 moves[4];
  fromLanes(correction, moves);
  for (int k = 0; k < 4; ++k) v[k]->q += moves[k];
}

// Writes a vector into one lane.
inline void setLane(Vec3x4& lanes, int lane, const Vec3& v) {
  lanes.x[lane] = static_cast<float>(v.x);
  lanes.y[lane] = static_cast<float>(v.y);
  lanes.z[lane] = static_cast<float>(v.z);
}

}  // namespace limber
