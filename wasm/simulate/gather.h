#pragma once

#include <cstdint>

#include "simulate/particles.h"

namespace limber {

// How far four vertices are from where the step started, one per lane.
inline Vec3x4 gatherMotion(const Motion* motion, const uint32_t (&v)[4]) {
  const Float4 moved[4] = {motion[v[0]].u + motion[v[0]].q, motion[v[1]].u + motion[v[1]].q,
                           motion[v[2]].u + motion[v[2]].q, motion[v[3]].u + motion[v[3]].q};
  return toLanes(moved);
}

inline Vec3x4 gatherPlaces(const Float4* place, const uint32_t (&v)[4]) {
  const Float4 found[4] = {place[v[0]], place[v[1]], place[v[2]], place[v[3]]};
  return toLanes(found);
}

// Adds one correction per lane to the substep's motion of four different vertices (or of the idle one, by 0).
inline void scatterCorrection(Motion* motion, const uint32_t (&v)[4], const Vec3x4& correction) {
  Float4 moves[4];
  fromLanes(correction, moves);
  for (int k = 0; k < 4; ++k) motion[v[k]].q += moves[k];
}

// Puts a vector of space into one lane.
inline void setLane(Vec3x4& lanes, int lane, const Vec3& v) {
  lanes.x[lane] = static_cast<float>(v.x);
  lanes.y[lane] = static_cast<float>(v.y);
  lanes.z[lane] = static_cast<float>(v.z);
}

}  // namespace limber
