#include "simulate/particles.h"

namespace limber {

namespace {

// sum += term; the rounding error of the sum is stored in `lost` and added the next time.
inline void addExactly(Float4& sum, Float4& lost, Float4 term) {
  const Float4 corrected = term + lost, total = sum + corrected;
  lost = corrected - (total - sum);
  sum = total;
}

template <bool moves, bool accelerates>
void advanceAs(Particles& particles, uint32_t begin, uint32_t end) {
  const Motion* const last = particles.motion.data() + end;
  Motion* lost = particles.lost.data() + begin;
  const Float4* acceleration = particles.acceleration.data() + begin;
  const float* damping = particles.damping.data() + begin;
  for (Motion* motion = particles.motion.data() + begin; motion != last;
       ++motion, ++lost, ++acceleration, ++damping) {
    const Float4 q = motion->q;
    if constexpr (moves) addExactly(motion->u, lost->u, q);
    if constexpr (accelerates) addExactly(motion->q, lost->q, *acceleration - splat(*damping) * q);
  }
}

}  // namespace

void advance(Particles& particles, uint32_t begin, uint32_t end, const Advance& what) {
  if (what.moves && what.accelerates)
    advanceAs<true, true>(particles, begin, end);
  else if (what.moves)
    advanceAs<true, false>(particles, begin, end);
  else
    advanceAs<false, true>(particles, begin, end);
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
