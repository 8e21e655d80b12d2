#pragma once

#include "base/vec3.h"

namespace limber {

// Cuts a triangle into cuts^2 equal parts by lines parallel to its edges, `cuts` >= 1, and calls visit(u, v)
// for the centre of each: the point at p + (q - p) u / cuts + (r - p) v / cuts of triangle pqr. The parts
// come in rows of growing u; a part that points the other way follows the one before it.
template <class Visit>
void forEachPart(int cuts, const Visit& visit) {
  for (int i = 0; i < cuts; ++i)
    for (int j = 0; i + j < cuts; ++j) {
      visit(i + 1.0 / 3, j + 1.0 / 3);
      if (i + j + 1 < cuts) visit(i + 2.0 / 3, j + 2.0 / 3);
    }
}

// Calls visit(position) for the centres of the cuts^2 equal parts of triangle pqr, in the same order.
template <class Visit>
void forEachPartCentre(const Vec3& p, const Vec3& q, const Vec3& r, int cuts, const Visit& visit) {
  const Vec3 alongQ = (q - p) / cuts, alongR = (r - p) / cuts;
  forEachPart(cuts, [&](double u, double v) { visit(p + alongQ * u + alongR * v); });
}

}  // namespace limber
