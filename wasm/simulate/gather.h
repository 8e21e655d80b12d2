#pragma once

#include <cstdint>

#include "simulate/particles.h"

namespace limber {

// Batches hold where their vertices' motions are, not their numbers: a place takes no arithmetic.
using MotionPlaces = Motion* [4];

// How far four vertices are from where the step started, one per lane.
inline Vec3x4 gatherMotion(const MotionPlaces& v) {
  const Float4 moved[4] = {v[0]->u + v[0]->q, v[1]->u + v[1]->q, v[2]->u + v[2]->q, v[3]->u + v[3]->q};
  return toLanes(moved);
}

inline Vec3x4 gatherPlaces(const Float4* place, const uint32_t (&v)[4]) {
  const Float4 found[4] = {place[v[0]], place[v[1]], place[v[2]], place[v[3]]};
  return toLanes(found);
}

// Adds one correction per lane to the substep's motion of four different vertices (or of the idle one, by 0).
inline void scatterCorrection(const MotionPlaces& v, const Vec3x4& correction) {
  Float4 moves[4];
  fromLanes(correction, moves);
  for (int k = 0; k < 4; ++k) v[k]->q += moves[k];
}

// Puts a vector of space into one lane.
inline void setLane(Vec3x4& lanes, int lane, const Vec3& v) {
  lanes.x[lane] = static_cast<float>(v.x);
  lanes.y[lane] = static_cast<float>(v.y);
  lanes.z[lane] = static_cast<float>(v.z);
}

}  // namespace limber
