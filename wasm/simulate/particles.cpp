#include "simulate/particles.h"

namespace limber {

namespace {

// sum += term, keeping what is lost for the next time.
inline void addExactly(Float4& sum, Float4& lost, Float4 term) {
  const Float4 corrected = term + lost, total = sum + corrected;
  lost = corrected - (total - sum);
  sum = total;
}

}  // namespace

void advance(Particles& particles, uint32_t begin, uint32_t end, const Advance& what) {
  Motion *motion = particles.motion.data(), *lost = particles.lost.data();
  const Float4* acceleration = particles.acceleration.data();
  const float* damping = particles.damping.data();
  for (uint32_t v = begin; v < end; ++v) {
    const Float4 q = motion[v].q;
    if (what.moves) addExactly(motion[v].u, lost[v].u, q);
    if (what.accelerates) addExactly(motion[v].q, lost[v].q, acceleration[v] - splat(damping[v]) * q);
  }
}

void finishStep(Particles& particles, uint32_t begin, uint32_t end) {
  for (uint32_t v = begin; v < end; ++v) {
    Motion& motion = particles.motion[v];
    for (int c = 0; c < 3; ++c)
      particles.positions[v][c] += double{motion.u[c]} + double{particles.lost[v].u[c]};
    motion.u = particles.lost[v].u = Float4{};
  }
}

}  // namespace limber
